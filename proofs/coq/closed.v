(** Closed forms in hyperbolic functions, the power law that no chain beats, and falling balls. *)

From Carom Require Import vocabulary weighted_mean chain threshold tactics collision transfer many.
From Carom Require statements.
From Coq Require Import Lra Lia.

Lemma cosh_pos : forall x, 0 < cosh x.
Proof. intro x. unfold cosh. assert (a := exp_pos x). assert (b := exp_pos (- x)). lra. Qed.

(** The sum of two powers by their geometric mean. *)
Lemma two_exponentials : forall a b, exp a + exp b = 2 * exp ((a + b) / 2) * cosh ((a - b) / 2).
Proof.
  intros a b. unfold cosh.
  transitivity (exp ((a + b) / 2) * exp ((a - b) / 2) + exp ((a + b) / 2) * exp (- ((a - b) / 2))); [| field].
  rewrite <- !exp_plus. f_equal; f_equal; field.
Qed.

Lemma exp_power : forall a n, exp a ^ n = exp (INR n * a).
Proof.
  intros a n. induction n as [| n ih]; [cbn; rewrite Rmult_0_l, exp_0; reflexivity |].
  rewrite S_INR. cbn [pow]. rewrite ih, <- exp_plus. f_equal. ring.
Qed.

Lemma amount_closed : forall m1 m2 k, m1 > 0 -> m2 > 0 -> (k >= 1)%nat ->
  amount m1 m2 k = exp ((ln m1 + ln m2) / 2) * 2 ^ k * cosh (ln (m1 / m2) / 2 / INR k) ^ k.
Proof.
  intros m1 m2 k h1 h2 hk. assert (i := INR_pos k hk). unfold amount, Rpower. rewrite two_exponentials.
  rewrite !Rpow_mult_distr, exp_power. rewrite ln_div by assumption.
  replace (INR k * ((1 / INR k * ln m1 + 1 / INR k * ln m2) / 2)) with ((ln m1 + ln m2) / 2) by (field; lra).
  replace ((1 / INR k * ln m1 - 1 / INR k * ln m2) / 2) with ((ln m1 - ln m2) / 2 / INR k) by (field; lra). ring.
Qed.

Lemma mean_square : forall m1 m2, m1 > 0 -> m2 > 0 -> exp ((ln m1 + ln m2) / 2) ^ 2 = m1 * m2.
Proof.
  intros m1 m2 h1 h2. rewrite exp_power. replace (INR 2 * ((ln m1 + ln m2) / 2)) with (ln m1 + ln m2) by (cbn; field).
  rewrite exp_plus, !exp_ln by assumption. reflexivity.
Qed.

Lemma quotient_power : forall a c k, 0 < c -> (a / 2 * / c) ^ k = a ^ k / (2 ^ k * c ^ k).
Proof.
  intros a c k hc. unfold Rdiv. rewrite !Rpow_mult_distr, !pow_inv. field. split; pos.
Qed.

Theorem b_closed : statements.b_closed.
Proof.
  start. split.
  - rewrite !double_power. fold (amount m1 m2 (n + 1)). rewrite amount_closed by (try assumption; lia).
    unfold sech. set (c := cosh _). assert (hc : 0 < c) by apply cosh_pos.
    rewrite quotient_power by lra. rewrite !Rpow_mult_distr. rewrite mean_square by assumption. field. repeat split; pos.
  - fold (amount m1 m2 (n + 1)). fold (amount m1 m2 n). rewrite !amount_closed by (try assumption; lia).
    set (c := cosh (_ / INR (n + 1))). set (d := cosh (_ / INR n)).
    assert (hc : 0 < c) by apply cosh_pos. assert (hd : 0 < d) by apply cosh_pos.
    rewrite (pow_add 2), pow_1. field. repeat split; pos.
Qed.

Theorem b_closed_defined : statements.b_closed_defined.
Proof. start. repeat split; try pos. apply Rgt_not_eq, cosh_pos. Qed.

(** ** The power law *)

Lemma ln_quotient_power : forall x y z, x > 0 -> y > 0 -> Rpower (x / y) z = exp (z * (ln x - ln y)).
Proof. intros x y z hx hy. unfold Rpower. now rewrite ln_div. Qed.

(** What the definition of u and e says in logarithms. *)
Lemma restitution_log : forall u, ln (1 + (2 * cosh u / exp (u * tanh u) - 1)) = ln (2 * cosh u) - u * tanh u.
Proof.
  intro u. assert (c := cosh_pos u). replace (1 + (2 * cosh u / exp (u * tanh u) - 1)) with (2 * cosh u / exp (u * tanh u)) by ring.
  rewrite ln_div; [| lra | apply exp_pos]. now rewrite ln_exp.
Qed.

Lemma restitution_pos : forall u, 0 < 1 + (2 * cosh u / exp (u * tanh u) - 1).
Proof.
  intro u. assert (c := cosh_pos u). assert (q := exp_pos (u * tanh u)).
  replace (1 + (2 * cosh u / exp (u * tanh u) - 1)) with (2 * cosh u / exp (u * tanh u)) by ring. pos.
Qed.

(** w = e^(2u): 1 + w = 2 e^u cosh u, and w/(1 + w) = (1 + tanh u)/2. *)
Lemma step_log : forall w, w > 0 -> ln (1 + w) = ln w / 2 + ln (2 * cosh (ln w / 2)).
Proof.
  intros w hw. set (u := ln w / 2). assert (c := cosh_pos u).
  rewrite <- (ln_exp u) at 1. rewrite <- ln_mult; [| apply exp_pos | lra]. f_equal. unfold cosh.
  replace (exp u * (2 * ((exp u + exp (- u)) / 2))) with (exp u * exp u + exp u * exp (- u)) by field.
  rewrite <- !exp_plus. replace (u + - u) with 0 by ring. replace (u + u) with (ln w) by (unfold u; field).
  rewrite exp_0, exp_ln by exact hw. ring.
Qed.

Lemma weight : forall w, w > 0 -> w / (1 + w) = (1 + tanh (ln w / 2)) / 2.
Proof.
  intros w hw. set (u := ln w / 2). unfold tanh, sinh, cosh.
  assert (a := exp_pos u). assert (b := exp_pos (- u)).
  assert (e : w = exp u / exp (- u)).
  { unfold Rdiv. rewrite <- exp_Ropp, <- exp_plus. replace (u + - - u) with (ln w) by (unfold u; field).
    symmetry. now apply exp_ln. }
  rewrite e. field. lra.
Qed.

Section Power.
Variables w m1 m2 N : R.
Hypotheses (hw : w > 1) (h1 : m1 > 0) (h2 : m2 > 0) (hN : N > 0).
Let u := ln w / 2.
Let e := 2 * cosh u / exp (u * tanh u) - 1.
Let eta a b := Rpower (1 + e) (2 * N) * a * b / Rpower (Rpower a (1 / N) + Rpower b (1 / N)) (2 * N).

Lemma share_log : forall a b, a > 0 -> b > 0 ->
  eta a b = exp (2 * N * ln (1 + e) + ln a + ln b - 2 * N * ln (Rpower a (1 / N) + Rpower b (1 / N))).
Proof.
  intros a b ha hb. unfold eta. unfold Rminus. rewrite !exp_plus, exp_Ropp, !exp_ln by assumption. reflexivity.
Qed.

Lemma power_law : forall a b, a > 0 -> b > 0 -> eta a b <= Rpower (a / b) (tanh u).
Proof.
  intros a b ha hb. rewrite share_log by assumption. rewrite ln_quotient_power by assumption.
  assert (p1 : 0 < Rpower a (1 / N)) by apply exp_pos. assert (p2 : 0 < Rpower b (1 / N)) by apply exp_pos.
  assert (t := tangent (Rpower a (1 / N)) (Rpower b (1 / N)) w p1 p2 ltac:(lra)).
  rewrite weight in t by lra. fold u in t. apply Rge_le in t.
  assert (q : 0 < Rpower a (1 / N) * (1 + w) * Rpower (Rpower b (1 / N) / (Rpower a (1 / N) * w)) ((1 + tanh u) / 2)).
  { assert (0 < 1 + w) by lra. pos. }
  assert (l : ln (Rpower a (1 / N) * (1 + w) * Rpower (Rpower b (1 / N) / (Rpower a (1 / N) * w)) ((1 + tanh u) / 2))
    <= ln (Rpower a (1 / N) + Rpower b (1 / N))).
  { destruct t as [t | t]; [left; now apply ln_increasing | right; now rewrite t]. }
  rewrite !ln_mult in l; try assumption; try pos; try lra.
  unfold Rpower at 2 in l. rewrite ln_exp in l. rewrite ln_div in l; [| pos | assert (0 < w) by lra; pos].
  rewrite ln_mult in l; [| pos | lra]. unfold Rpower in l. rewrite !ln_exp in l.
  rewrite step_log in l by lra. fold u in l. replace (ln w) with (2 * u) in l by (unfold u; field).
  match goal with |- exp ?x <= exp ?y => assert (le : x <= y); [| destruct le as [le | le];
    [left; now apply exp_increasing | right; now rewrite le]] end.
  unfold e. rewrite restitution_log. unfold Rpower.
  set (S := ln (exp (1 / N * ln a) + exp (1 / N * ln b))) in *. set (C := ln (2 * cosh u)) in *. set (T := tanh u) in *.
  apply (Rmult_le_compat_l (2 * N)) in l; [| lra].
  replace (2 * N * (1 / N * ln a + (u + C) + (1 + T) / 2 * (1 / N * ln b - (1 / N * ln a + 2 * u))))
    with (2 * ln a + 2 * N * (u + C) + (1 + T) * (ln b - ln a - 2 * N * u)) in l by (field; lra). lra.
Qed.

End Power.

Theorem b_power : statements.b_power.
Proof.
  start. split; [| split].
  - assert (c := cosh_pos (ln w / 2)). rewrite ln_div; [| lra | apply restitution_pos]. rewrite restitution_log.
    rewrite ln_mult by lra. lra.
  - now apply power_law.
  - rewrite (Rplus_comm (Rpower m1 (1 / N))). rewrite (Rmult_assoc _ m1 m2), (Rmult_comm m1 m2), <- Rmult_assoc.
    now apply power_law.
Qed.

Theorem b_power_defined : statements.b_power_defined.
Proof.
  start. assert (c := cosh_pos (ln w / 2)). assert (r := restitution_pos (ln w / 2)).
  repeat split; try lra; try pos; try (apply Rgt_not_eq; lra).
Qed.

Theorem b_power_attained : statements.b_power_attained.
Proof.
  start. set (u := ln w / 2). assert (lw : 0 < ln w) by (rewrite <- ln_1; apply ln_increasing; lra).
  assert (hm : m2 * Rpower w N > 0) by pos.
  assert (lm : ln (m2 * Rpower w N) = ln m2 + 2 * u * N).
  { rewrite ln_mult; [| assumption | pos]. unfold Rpower. rewrite ln_exp. unfold u. field. }
  split.
  - rewrite ln_div by assumption. rewrite lm. unfold u. field. lra.
  - rewrite ln_quotient_power by assumption. etransitivity; [exact (share_log w N (m2 * Rpower w N) m2 hm H0) |]. fold u. f_equal.
    rewrite restitution_log, lm.
    assert (s : Rpower (m2 * Rpower w N) (1 / N) = w * Rpower m2 (1 / N)).
    { rewrite <- Rpower_mult_distr; [| assumption | pos]. rewrite Rpower_mult.
      replace (N * (1 / N)) with 1 by (field; lra). rewrite Rpower_1 by lra. ring. }
    rewrite s. replace (w * Rpower m2 (1 / N) + Rpower m2 (1 / N)) with (Rpower m2 (1 / N) * (1 + w)) by ring.
    rewrite (ln_mult (Rpower m2 (1 / N)) (1 + w)); [| pos | lra]. rewrite step_log by lra. fold u. unfold Rpower. rewrite ln_exp. field. lra.
Qed.

Theorem b_power_attained_defined : statements.b_power_attained_defined.
Proof.
  start. assert (lw : 0 < ln w) by (rewrite <- ln_1; apply ln_increasing; lra).
  assert (r := restitution_pos (ln w / 2)). repeat split; try lra; try pos; try (apply Rgt_not_eq; lra).
Qed.

(** The slope of the left side of the equation for the parameter. *)
Lemma slope : forall t, is_derive (fun t => t * tanh t - ln (cosh t)) t (t * sech t ^ 2).
Proof.
  intro t. assert (ct := cosh_pos t).
  unfold tanh, sech. auto_derive.
  + repeat split; try lra.
  + unfold sinh, cosh in *. assert (p := exp_pos t). assert (q := exp_pos (- t)).
    assert (pq : exp t * exp (- t) = 1) by (rewrite <- exp_plus, Rplus_opp_r; apply exp_0).
    field_simplify_eq; [| repeat split; lra].
    replace (16 * exp t * exp (- t) * t) with (16 * (exp t * exp (- t)) * t) by ring. rewrite pq. ring.
Qed.

Theorem b_power_range : statements.b_power_range.
Proof.
  start. assert (lw : 0 < ln w) by (rewrite <- ln_1; apply ln_increasing; lra).
  assert (s := tangent_strict 1 1 w ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra)).
  set (u := ln w / 2) in *. assert (c := cosh_pos u).
  assert (th : 0 < 1 + tanh u).
  { assert (k := weight w ltac:(lra)). fold u in k. assert (0 < w / (1 + w)) by pos. lra. }
  assert (v : 2 * cosh u / exp (u * tanh u) = exp (ln (2 * cosh u) - u * tanh u)).
  { unfold Rminus. rewrite exp_plus, exp_Ropp, exp_ln by lra. reflexivity. }
  assert (b : (1 + w) * Rpower (1 / (1 * w)) (w / (1 + w)) = exp (ln (2 * cosh u) - u * tanh u)).
  { rewrite weight by lra. fold u. unfold Rpower. rewrite Rmult_1_l. unfold Rdiv at 2. rewrite Rmult_1_l.
    rewrite ln_Rinv by lra. rewrite <- (exp_ln (1 + w)) at 1 by lra. rewrite <- exp_plus. f_equal.
    rewrite step_log by lra. fold u. replace (ln w) with (2 * u) by (unfold u; field). field. }
  split; [split |].
  - rewrite v. assert (1 < exp (ln (2 * cosh u) - u * tanh u)); [| lra]. rewrite <- exp_0. apply exp_increasing.
    assert (up : u < ln (2 * cosh u)).
    { rewrite <- (ln_exp u) at 1. apply ln_increasing; [apply exp_pos |]. unfold cosh. assert (p := exp_pos (- u)). lra. }
    assert (tu : tanh u < 1).
    { assert (k := weight w ltac:(lra)). fold u in k. assert (w / (1 + w) < 1 / 1) by (apply quotient_lt_iff; lra). lra. }
    assert (u * tanh u < u * 1) by (apply Rmult_lt_compat_l; [unfold u; lra | exact tu]). lra.
  - rewrite v, <- b. lra.
  - assert (ct := cosh_pos t). split; [apply slope | unfold sech; pos].
Qed.

Theorem b_power_range_defined : statements.b_power_range_defined.
Proof.
  start. assert (ct := cosh_pos t). assert (e := exp_pos (ln w / 2 * tanh (ln w / 2))).
  repeat split; try lra; try (apply Rgt_not_eq; exact e). exists (t * sech t ^ 2). apply slope.
Qed.

(** ** Falling balls *)

Lemma near_two : is_lim (fun x => 2 * x / (x + 1)) p_infty 2.
Proof.
  apply is_lim_ext_loc with (fun x => 2 - 2 * / (x + 1)).
  - exists 0. intros x hx. field. lra.
  - replace (Finite 2) with (Finite (2 - 2 * 0)) by (f_equal; ring).
    apply is_lim_minus'; [apply is_lim_const |].
    apply (is_lim_scal_l (fun x => / (x + 1)) 2 p_infty 0).
    replace (Finite 0) with (Rbar_inv p_infty) by reflexivity. apply is_lim_inv; [| discriminate].
    apply is_lim_plus with p_infty 1; [apply is_lim_id | apply is_lim_const | reflexivity].
Qed.

Theorem b_superball_limit : statements.b_superball_limit.
Proof.
  start. assert (speed : is_lim (fun x => 2 * (2 * x / (x + 1)) - 1) p_infty 3).
  { replace (Finite 3) with (Finite (2 * 2 - 1)) by (f_equal; ring).
    apply is_lim_minus'; [| apply is_lim_const]. exact (is_lim_scal_l _ 2 p_infty 2 near_two). }
  split.
  - apply is_lim_ext_loc with (2 := speed). exists 0. intros y hy. field. lra.
  - apply is_lim_ext_loc with (fun x => (2 * (2 * x / (x + 1)) - 1) * (2 * (2 * x / (x + 1)) - 1)).
    + exists 0. intros y hy. field. lra.
    + replace (Finite 9) with (Finite (3 * 3)) by (f_equal; ring).
      exact (is_lim_mult _ _ p_infty 3 3 speed speed I).
Qed.

Theorem b_superball_limit_defined : statements.b_superball_limit_defined.
Proof. values. Qed.
