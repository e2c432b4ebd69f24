/* Timing and output shared by the C programs: the median time of one call, and the line of JSON for a case. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

/* The digits of J3. */
enum { SIZES = 8 };
static const long sizes[SIZES] = {100, 150, 200, 600, 1000, 10000, 100000, 1000000};

static int argc_all;
static char **argv_all;

static double now(void) {
  struct timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return t.tv_sec + 1e-9 * t.tv_nsec;
}

static int order(const void *a, const void *b) {
  double x = *(const double *)a, y = *(const double *)b;
  return (x > y) - (x < y);
}

static double measure(void (*compute)(void)) {
  double begin = now(), rounds[9];
  compute();
  double once = now() - begin;
  if (once > 0.02) return once;
  long calls = 0.02 / (once > 2e-8 ? once : 2e-8);
  if (calls < 1) calls = 1;
  for (int i = 0; i < 9; i++) {
    begin = now();
    for (long k = 0; k < calls; k++) compute();
    rounds[i] = (now() - begin) / calls;
  }
  qsort(rounds, 9, sizeof(double), order);
  return rounds[4];
}

static int wanted(const char *name) {
  for (int i = 3; i < argc_all; i++)
    if (!strcmp(argv_all[i], name)) return 1;
  return argc_all <= 3;
}

static void report(const char *name, double seconds, const char *answer) {
  printf("{\"case\": \"%s\", \"seconds\": %.9e, \"answer\": \"%s\"}\n", name, seconds, answer);
  fflush(stdout);
}

static double *doubles(const char *work, const char *file, long count) {
  char path[4096];
  snprintf(path, sizeof path, "%s/%s", work, file);
  double *all = malloc(count * sizeof(double));
  FILE *f = fopen(path, "rb");
  if (!f || fread(all, sizeof(double), count, f) != (size_t)count) exit(2);
  fclose(f);
  return all;
}

/* Writes the lower, then the upper ends, and gives the path. */
static const char *ends(const char *work, const char *name, const double *lower, const double *upper, long count) {
  static char path[4096];
  snprintf(path, sizeof path, "%s/%s.ends", work, name);
  FILE *f = fopen(path, "wb");
  fwrite(lower, sizeof(double), count, f);
  fwrite(upper, sizeof(double), count, f);
  fclose(f);
  return path;
}
