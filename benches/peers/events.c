/* J9 in plain C, uncertified: up to ten collisions a body in a dilute line.
   J9 is the loop that a student would write: look at all pairs for the next collision, move all bodies there.
   J9-heap keeps the pairs in a heap and each body's own time; what is no longer true stays in the heap until it comes up.
   The answer is the number of collisions and the sum of the places of their pairs. */
#include <math.h>
#include "timing.h"

static long bodies;
static double *mass, *start, *speed, *e, *x, *v, *t;
static long count, sum;

static void collide(long i) {
  double push = (1 + e[i]) * (v[i] - v[i + 1]) / (mass[i] + mass[i + 1]);
  v[i] -= push * mass[i + 1];
  v[i + 1] += push * mass[i];
  count++, sum += i + 1;
}

static void begin(void) {
  memcpy(x, start, bodies * sizeof(double));
  memcpy(v, speed, bodies * sizeof(double));
  memset(t, 0, bodies * sizeof(double));
  count = sum = 0;
}

static void scan(void) {
  begin();
  while (count < 10 * bodies) {
    double least = INFINITY;
    long first = -1;
    for (long i = 0; i + 1 < bodies; i++)
      if (v[i] > v[i + 1]) {
        double due = (x[i + 1] - x[i]) / (v[i] - v[i + 1]);
        if (due < least) least = due, first = i;
      }
    if (first < 0) return;
    for (long i = 0; i < bodies; i++) x[i] += v[i] * least;
    collide(first);
  }
}

typedef struct { double due; long pair, version; } Entry;
static Entry *heap;
static long size, *version;

static void push(long i) {
  version[i]++;
  if (v[i] <= v[i + 1]) return;
  double late = fmax(t[i], t[i + 1]);
  double gap = x[i + 1] + v[i + 1] * (late - t[i + 1]) - x[i] - v[i] * (late - t[i]);
  Entry new = {late + gap / (v[i] - v[i + 1]), i, version[i]};
  long at = size++;
  for (; at && heap[(at - 1) / 2].due > new.due; at = (at - 1) / 2) heap[at] = heap[(at - 1) / 2];
  heap[at] = new;
}

static Entry pop(void) {
  Entry first = heap[0], last = heap[--size];
  long at = 0;
  for (long child; (child = 2 * at + 1) < size; at = child) {
    if (child + 1 < size && heap[child + 1].due < heap[child].due) child++;
    if (heap[child].due >= last.due) break;
    heap[at] = heap[child];
  }
  heap[at] = last;
  return first;
}

static void queue(void) {
  begin();
  size = 0;
  memset(version, 0, bodies * sizeof(long));
  for (long i = 0; i + 1 < bodies; i++) push(i);
  while (count < 10 * bodies && size) {
    Entry next = pop();
    long i = next.pair;
    if (next.version != version[i]) continue;
    for (long k = i; k < i + 2; k++) x[k] += v[k] * (next.due - t[k]), t[k] = next.due;
    collide(i);
    if (i) push(i - 1);
    push(i);
    if (i + 2 < bodies) push(i + 1);
  }
}

int main(int argc, char **argv) {
  argc_all = argc, argv_all = argv;
  for (bodies = 10; bodies <= 10000; bodies *= 10) {
    char name[32], path[4096], answer[64];
    snprintf(name, sizeof name, "%ld", bodies);
    if (!wanted(name)) continue;
    double **arrays[] = {&mass, &start, &speed, &e, &x, &v, &t};
    for (int k = 0; k < 7; k++) *arrays[k] = malloc(bodies * sizeof(double));
    version = malloc(bodies * sizeof(long)), heap = malloc(40 * bodies * sizeof(Entry));
    snprintf(path, sizeof path, "%s/J9-%ld.txt", argv[2], bodies);
    FILE *f = fopen(path, "r");
    for (long i = 0; f && i < bodies; i++) {
      double m, p, q, a, b, c, d;
      if (fscanf(f, "%lf %lf %lf %lf %lf %lf %lf", &m, &p, &q, &a, &b, &c, &d) != 7) return 2;
      mass[i] = m, start[i] = p / q, speed[i] = a / b, e[i] = c / d;
    }
    if (!f) return 2;
    fclose(f);
    double seconds = measure(strcmp(argv[1], "J9-heap") ? scan : queue) / count;
    snprintf(answer, sizeof answer, "%ld %ld", count, sum);
    report(name, seconds, answer);
  }
}
