/* Arb from C: J2a, J2b and J3, certified balls; 64 bits for the cells.
   Tried: arb_root_ui against exp(log/n) (slower below n = 16 at 64 bits), 53 bits instead of 64 (no faster), a root
   of 56 instead of two smaller ones, three square roots instead of an eighth root (twice as fast at 10^5 digits). */
#include <arb.h>
#include "timing.h"

enum { CELLS = 100000, SIDE = 1000, WORD = 64 };
static double *e, *r, *n;
static arb_ptr out;
static long bits;

static void cell(arb_t x, const arb_t e1, const arb_t r, ulong n) {
  static int ready;
  static arb_t t;
  if (!ready) arb_init(t), ready = 1;
  arb_root_ui(t, r, n, WORD);
  arb_add_ui(x, t, 1, WORD);
  arb_div(x, e1, x, WORD);
  arb_mul(x, x, x, WORD);
  arb_mul(x, x, t, WORD);
  arb_pow_ui(x, x, n, WORD);
}

static arb_ptr up, ratios;

static void scattered(void) {
  for (long i = 0; i < CELLS; i++) cell(out + i, up + i, ratios + i, (ulong)n[i]);
}

static void grid(void) {
  static arb_ptr a, b;
  arb_t two;
  if (!a) a = _arb_vec_init(SIDE), b = _arb_vec_init(SIDE);
  arb_init(two);
  arb_set_ui(two, 2);
  for (long i = 0; i < SIDE; i++) {
    arb_mul_2exp_si(a + i, up + i, -1);
    arb_pow_ui(a + i, a + i, 16, WORD);
    cell(b + i, two, ratios + i, 8);
  }
  for (long i = 0; i < SIDE; i++)
    for (long j = 0; j < SIDE; j++) arb_mul(out + i * SIDE + j, a + i, b + j, WORD);
  arb_clear(two);
}

static void prepare(long cells) {
  up = _arb_vec_init(cells), ratios = _arb_vec_init(cells);
  for (long i = 0; i < cells; i++) {
    arb_set_d(up + i, e[i]);
    arb_add_ui(up + i, up + i, 1, 200);
    arb_set_d(ratios + i, r[i]);
  }
}

static const char *answer(const char *work, const char *name, long count) {
  double *lower = malloc(count * sizeof(double)), *upper = malloc(count * sizeof(double));
  arf_t x;
  arf_init(x);
  for (long i = 0; i < count; i++) {
    arb_get_lbound_arf(x, out + i, 100);
    lower[i] = arf_get_d(x, ARF_RND_FLOOR);
    arb_get_ubound_arf(x, out + i, 100);
    upper[i] = arf_get_d(x, ARF_RND_CEIL);
  }
  return ends(work, name, lower, upper, count);
}

static arb_t value, root8, root7, half;

static void eighth(void) {
  arb_sqrt_ui(root8, 10, bits);
  arb_sqrt(root8, root8, bits);
  arb_sqrt(root8, root8, bits);
}

static void eta(void) {
  fmpz_t ten, nineteen;
  fmpz_init_set_ui(ten, 10), fmpz_init_set_ui(nineteen, 19);
  eighth();
  arb_add_ui(half, root8, 1, bits);
  arb_mul(half, half, half, bits);
  arb_div(value, root8, half, bits);
  for (int i = 0; i < 3; i++) arb_mul(value, value, value, bits);
  fmpz_pow_ui(nineteen, nineteen, 16), fmpz_pow_ui(ten, ten, 16);
  arb_mul_fmpz(value, value, nineteen, bits);
  arb_div_fmpz(value, value, ten, bits);
  fmpz_clear(ten), fmpz_clear(nineteen);
}

static void threshold(void) {
  eighth();
  arb_add_ui(value, root8, 1, bits);
  for (int i = 0; i < 3; i++) arb_mul(value, value, value, bits);
  arb_set_ui(root7, 10);
  arb_root_ui(root7, root7, 7, bits);
  arb_add_ui(root7, root7, 1, bits);
  arb_pow_ui(half, root7, 7, bits);
  arb_div(value, value, half, bits);
  arb_sub_ui(value, value, 1, bits);
}

static void digits(void) {
  arb_init(value), arb_init(root8), arb_init(root7), arb_init(half);
  fmpz_t prime, scale, floor;
  fmpz_init(prime), fmpz_init(scale), fmpz_init(floor);
  fmpz_one(prime), fmpz_mul_2exp(prime, prime, 127), fmpz_sub_ui(prime, prime, 1);
  for (int k = 0; k < SIZES; k++)
    for (int which = 0; which < 2; which++) {
      long count = sizes[k];
      char name[40];
      snprintf(name, sizeof name, "%s/%ld", which ? "L_7" : "eta", count);
      if (!wanted(name)) continue;
      bits = (long)(count * 3.3219280948874) + 40;
      double t = measure(which ? threshold : eta);
      fmpz_set_ui(scale, 10);
      fmpz_pow_ui(scale, scale, count - 10);
      arb_mul_fmpz(value, value, scale, bits);
      arb_floor(value, value, bits);
      if (!arb_get_unique_fmpz(floor, value)) exit(3);
      fmpz_mod(floor, floor, prime);
      report(name, t, fmpz_get_str(NULL, 10, floor));
    }
}

int main(int argc, char **argv) {
  argc_all = argc, argv_all = argv;
  const char *job = argv[1], *work = argv[2];
  if (!strcmp(job, "J3")) {
    digits();
  } else if (!strcmp(job, "J2a")) {
    e = doubles(work, "J2a.bin", 3 * CELLS), r = e + CELLS, n = r + CELLS;
    out = _arb_vec_init(CELLS);
    prepare(CELLS);
    double t = measure(scattered) / CELLS;
    report("one of 100000 cells", t, answer(work, "J2a-arb", CELLS));
  } else if (!strcmp(job, "J2b")) {
    e = doubles(work, "J2b.bin", 2 * SIDE), r = e + SIDE;
    out = _arb_vec_init(SIDE * SIDE);
    prepare(SIDE);
    double t = measure(grid) / (SIDE * SIDE);
    report("one of 1000000 cells", t, answer(work, "J2b-arb", SIDE * SIDE));
  } else {
    /* J8: the first answer of a fresh process, 15 digits of eta. */
    bits = 80;
    arb_init(value), arb_init(root8), arb_init(half);
    eta();
    arb_printn(value, 15, ARB_STR_NO_RADIUS);
    printf("\n");
  }
}
