/* J2 in plain C, uncertified: the t-form with libm's pow; the limit of what doubles can do.
   Tried: exp(log(r)/n) for the root (the same speed), pow for the last power (a third slower than products),
   -ffast-math (no gain: libm's scalar pow takes the time). */
#include <math.h>
#include "timing.h"

enum { CELLS = 100000, SIDE = 1000 };
static double *e, *r, *n, *out;

static double power(double x, long k) {
  double y = 1;
  for (; k; k >>= 1, x *= x)
    if (k & 1) y *= x;
  return y;
}

static double t_form(double e, double r, long n) {
  double t = pow(r, 1.0 / n), f = (1 + e) / (1 + t);
  return power(f * f * t, n);
}

static void scattered(void) {
  for (long i = 0; i < CELLS; i++) out[i] = t_form(e[i], r[i], (long)n[i]);
}

static void each(void) {
  for (long i = 0; i < SIDE; i++)
    for (long j = 0; j < SIDE; j++) out[i * SIDE + j] = t_form(e[i], r[j], 8);
}

static void separable(void) {
  static double a[SIDE], b[SIDE];
  for (long i = 0; i < SIDE; i++) a[i] = power((1 + e[i]) / 2, 16);
  for (long j = 0; j < SIDE; j++) {
    double t = pow(r[j], 0.125);
    b[j] = power(4 * t / ((1 + t) * (1 + t)), 8);
  }
  for (long i = 0; i < SIDE; i++)
    for (long j = 0; j < SIDE; j++) out[i * SIDE + j] = a[i] * b[j];
}

int main(int argc, char **argv) {
  argc_all = argc, argv_all = argv;
  const char *job = argv[1], *work = argv[2];
  if (!strcmp(job, "J8")) {
    printf("%.15g\n", t_form(0.9, 10, 8));
    return 0;
  }
  out = malloc(SIDE * SIDE * sizeof(double));
  if (!strcmp(job, "J2a")) {
    e = doubles(work, "J2a.bin", 3 * CELLS), r = e + CELLS, n = r + CELLS;
    double t = measure(scattered) / CELLS;
    report("one of 100000 cells", t, ends(work, "J2a-c", out, out, CELLS));
  } else {
    e = doubles(work, "J2b.bin", 2 * SIDE), r = e + SIDE;
    int factors = !strcmp(job, "J2b-separable");
    double t = measure(factors ? separable : each) / (SIDE * SIDE);
    report("one of 1000000 cells", t, ends(work, factors ? "J2b-c-separable" : "J2b-c", out, out, SIDE * SIDE));
  }
}
