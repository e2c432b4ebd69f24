/* J3 with MPFR: each operation correctly rounded, the whole uncertified.
   Tried: mpfr_pow_ui (slower than the squarings), mpfr_rootn_ui(8) (slower than three square roots). */
#include <gmp.h>
#include <mpfr.h>
#include "timing.h"

static mpfr_t value, root8, root7, half;
static mpz_t x, y, xy;

/* What the others are measured by: one product of GMP. */
static void product(void) { mpz_mul(xy, x, y); }

static void eighth(void) {
  mpfr_sqrt_ui(root8, 10, MPFR_RNDN);
  mpfr_sqrt(root8, root8, MPFR_RNDN);
  mpfr_sqrt(root8, root8, MPFR_RNDN);
}

static void eta(void) {
  eighth();
  mpfr_add_ui(half, root8, 1, MPFR_RNDN);
  mpfr_sqr(half, half, MPFR_RNDN);
  mpfr_div(value, root8, half, MPFR_RNDN);
  mpfr_mul_ui(value, value, 361, MPFR_RNDN);
  mpfr_div_ui(value, value, 100, MPFR_RNDN);
  for (int i = 0; i < 3; i++) mpfr_sqr(value, value, MPFR_RNDN);
}

static void threshold(void) {
  eighth();
  mpfr_add_ui(value, root8, 1, MPFR_RNDN);
  for (int i = 0; i < 3; i++) mpfr_sqr(value, value, MPFR_RNDN);
  mpfr_set_ui(root7, 10, MPFR_RNDN);
  mpfr_rootn_ui(root7, root7, 7, MPFR_RNDN);
  mpfr_add_ui(root7, root7, 1, MPFR_RNDN);
  mpfr_sqr(half, root7, MPFR_RNDN);
  mpfr_mul(root7, half, root7, MPFR_RNDN);
  mpfr_sqr(half, half, MPFR_RNDN);
  mpfr_mul(half, half, root7, MPFR_RNDN);
  mpfr_div(value, value, half, MPFR_RNDN);
  mpfr_sub_ui(value, value, 1, MPFR_RNDN);
}

int main(int argc, char **argv) {
  argc_all = argc, argv_all = argv;
  mpz_t floor, prime, scale;
  mpz_inits(floor, prime, scale, x, y, xy, NULL);
  mpz_ui_pow_ui(prime, 2, 127), mpz_sub_ui(prime, prime, 1);
  for (int k = 0; k < SIZES; k++)
    for (int which = 0; which < 2; which++) {
      long count = sizes[k];
      char name[40];
      snprintf(name, sizeof name, "%s/%ld", which ? "L_7" : "eta", count);
      if (!wanted(name)) continue;
      mpfr_inits2((long)(count * 3.3219280948874) + 40, value, root8, root7, half, (mpfr_ptr)0);
      double t = measure(which ? threshold : eta);
      mpz_ui_pow_ui(scale, 10, count - 10);
      mpfr_mul_z(value, value, scale, MPFR_RNDN);
      mpfr_get_z(floor, value, MPFR_RNDD);
      mpz_mod(floor, floor, prime);
      report(name, t, mpz_get_str(NULL, 10, floor));
      mpfr_clears(value, root8, root7, half, (mpfr_ptr)0);
    }
  for (int k = 0; k < SIZES; k++) {
    char name[40];
    snprintf(name, sizeof name, "product/%ld", sizes[k]);
    if (!wanted(name)) continue;
    mpz_ui_pow_ui(scale, 2, (long)(sizes[k] * 3.3219280948874) + 1), mpz_sub_ui(scale, scale, 1);
    mpz_fdiv_q_ui(x, scale, 3), mpz_fdiv_q_ui(y, scale, 7);
    report(name, measure(product), "");
  }
}
