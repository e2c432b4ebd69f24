(** One and two inserted bodies: the share that is handed on, its derivatives and its maximum. *)

From Carom Require Import vocabulary weighted_mean chain tactics collision.
From Carom Require statements.
From Coq Require Import Lra Lia.

(** ** Shares compared *)

(** k m^2 / q^2 is at most k / s^2 as soon as m s <= q, with equality only there. *)
Lemma best_share : forall k m s q, 0 < k -> 0 < m -> 0 < s -> m * s <= q ->
  k * m ^ 2 / q ^ 2 <= k / s ^ 2 /\ (k * m ^ 2 / q ^ 2 = k / s ^ 2 <-> q = m * s).
Proof.
  intros k m s q hk hm hs h. assert (ms : 0 < m * s) by pos. assert (hq : 0 < q) by lra. split.
  - apply quotient_le; [pos | pos |].
    replace (k * m ^ 2 * s ^ 2) with (k * (m * s) ^ 2) by ring.
    apply Rmult_le_compat_l; [lra | apply pow_incr; lra].
  - rewrite quotient_eq_iff by pos. split.
    + intro e. assert (z : k * (q + m * s) * (q - m * s) = 0) by lra.
      apply Rminus_diag_uniq. refine (proj1 (product_zero _ _ _) z). pos.
    + intros ->. ring.
Qed.

(** The share k E^2 / A^2 against k F^2 / B^2. *)
Lemma shares_compared : forall k E F A B, 0 < k -> 0 < E -> 0 < F -> 0 < A -> 0 < B ->
  (k * E ^ 2 / A ^ 2 >= k * F ^ 2 / B ^ 2 <-> E * B >= F * A).
Proof.
  intros k E F A B hk hE hF hA hB. assert (h1 : 0 < E * B) by pos. assert (h2 : 0 < F * A) by pos.
  split; intro h; apply Rge_le in h; apply Rle_ge.
  - apply quotient_le_inv in h; [| pos | pos].
    apply (proj1 (square_le_iff (F * A) (E * B) ltac:(lra) ltac:(lra))). apply Rmult_le_reg_l with k; [exact hk |]. lra.
  - apply quotient_le; [pos | pos |].
    apply (proj2 (square_le_iff (F * A) (E * B) ltac:(lra) ltac:(lra))) in h. apply (Rmult_le_compat_l k) in h; lra.
Qed.

Lemma shares_strict : forall k E F A B, 0 < k -> 0 < E -> 0 < F -> 0 < A -> 0 < B ->
  (k * E ^ 2 / A ^ 2 > k * F ^ 2 / B ^ 2 <-> E * B > F * A).
Proof.
  intros k E F A B hk hE hF hA hB. assert (c := shares_compared k F E B A hk hF hE hB hA).
  split; intro h; apply Rnot_le_lt; intro g; apply Rle_ge in g; apply c in g; lra.
Qed.

(** With F = 1: another body helps exactly if E >= A / B. *)
Lemma helps : forall k E A B, 0 < k -> 0 < E -> 0 < A -> 0 < B ->
  (k * E ^ 2 / A ^ 2 >= k / B ^ 2 <-> E >= A / B).
Proof.
  intros k E A B hk hE hA hB. replace (k / B ^ 2) with (k * 1 ^ 2 / B ^ 2) by (field; lra).
  rewrite shares_compared by (try assumption; lra).
  replace E with (E * B / B) at 2 by (field; lra). split; intro h.
  - apply Rle_ge, quotient_le; [lra | lra |]. apply Rmult_le_compat_r; lra.
  - apply Rge_le in h. apply quotient_le_inv in h; [| lra | lra].
    apply Rmult_le_reg_r in h; lra.
Qed.

(** ** Three bodies *)

Theorem eq12 : statements.eq12.
Proof. start. subst. split; field; lra. Qed.

Theorem eq12_defined : statements.eq12_defined.
Proof. values. Qed.

Theorem eq13 : statements.eq13.
Proof. start. field. lra. Qed.

Theorem eq13_defined : statements.eq13_defined.
Proof. values. Qed.

Lemma sqrt_product : forall a b, 0 < a -> 0 < b -> sqrt (a ^ 2 * b ^ 2) = a * b.
Proof. intros a b ha hb. replace (a ^ 2 * b ^ 2) with ((a * b) ^ 2) by ring. apply sqrt_pow2. left; pos. Qed.

Theorem eq14 : statements.eq14.
Proof.
  start. destruct (square_root m1 H) as (a & ha & h1 & ->). destruct (square_root m2 H0) as (b & hb & h2 & ->).
  rewrite h1, h2, sqrt_product by assumption.
  set (k := (1 + e1) ^ 2 * (1 + e2) ^ 2 * a ^ 2 * b ^ 2). assert (hk : 0 < k) by (unfold k; pos).
  split; [pos |]. split; [unfold k; field; split; nra |]. intros mu hmu.
  assert (q : (a ^ 2 + mu) * (mu + b ^ 2) = mu * (a + b) ^ 2 + (mu - a * b) ^ 2) by ring.
  assert (s := pow2_ge_0 (mu - a * b)).
  destruct (best_share k mu ((a + b) ^ 2) ((a ^ 2 + mu) * (mu + b ^ 2)) hk hmu ltac:(pos) ltac:(lra)) as [le eq].
  replace ((a ^ 2 + mu) ^ 2 * (mu + b ^ 2) ^ 2) with (((a ^ 2 + mu) * (mu + b ^ 2)) ^ 2) by ring.
  replace ((a + b) ^ 4) with (((a + b) ^ 2) ^ 2) by ring. split; [exact le |].
  intro h. apply eq in h. rewrite q in h. assert (z : (mu - a * b) ^ 2 = 0) by lra. nra.
Qed.

Theorem eq14_defined : statements.eq14_defined.
Proof. values. Qed.

Theorem eq15 : statements.eq15.
Proof.
  start. destruct (square_root m1 H) as (a & ha & h1 & ->). destruct (square_root m2 H0) as (b & hb & h2 & ->).
  rewrite h1, h2, sqrt_product by assumption. split.
  - replace ((1 + e) ^ 4 * a ^ 2 * b ^ 2 / (a + b) ^ 4)
      with ((1 + e) ^ 2 * a ^ 2 * b ^ 2 * (1 + e) ^ 2 / ((a + b) ^ 2) ^ 2) by (field; lra).
    rewrite helps by pos. split; intro; lra.
  - field. nra.
Qed.

Theorem eq15_defined : statements.eq15_defined.
Proof. values. Qed.

(** Three collisions compared with two: both shares are the same number times a square. *)
Lemma squares_compared : forall k x y, 0 < k -> 0 < x -> 0 < y ->
  (k * x ^ 2 >= k * y ^ 2 <-> x >= y) /\ (k * x ^ 2 = k * y ^ 2 <-> x = y).
Proof.
  intros k x y hk hx hy. split; split; intro h.
  - apply Rle_ge, (square_le_iff y x); [lra | lra |]. apply Rmult_le_reg_l with k; lra.
  - apply Rle_ge, Rmult_le_compat_l; [lra |]. apply pow_incr. lra.
  - apply Rmult_eq_reg_l in h; [| lra].
    apply Rle_antisym; apply square_le_iff; lra.
  - now rewrite h.
Qed.

Theorem b_insert_each : statements.b_insert_each.
Proof.
  start.
  replace ((1 + p) ^ 2 * (1 + q) ^ 2 * a * b * mu ^ 2 / ((a + mu) ^ 2 * (mu + b) ^ 2))
    with (a * b * ((1 + d) / ((a + mu) * (mu + b))) ^ 2 * ((1 + p) * (1 + q) * mu / (1 + d)) ^ 2)
    by (field; repeat split; pos).
  replace ((1 + d) ^ 2 * a * b / (a + b) ^ 2)
    with (a * b * ((1 + d) / ((a + mu) * (mu + b))) ^ 2 * ((a + mu) * (mu + b) / (a + b)) ^ 2)
    by (field; repeat split; pos).
  replace ((1 + p) * (1 + q) / (1 + d)) with ((1 + p) * (1 + q) * mu / (1 + d) / mu) by (field; repeat split; pos).
  replace (1 + (a * b + mu ^ 2) / (mu * (a + b))) with ((a + mu) * (mu + b) / (a + b) / mu)
    by (field; repeat split; pos).
  destruct (squares_compared (a * b * ((1 + d) / ((a + mu) * (mu + b))) ^ 2) ((1 + p) * (1 + q) * mu / (1 + d))
    ((a + mu) * (mu + b) / (a + b)) ltac:(pos) ltac:(pos) ltac:(pos)) as [order same].
  rewrite order, same. split; split; intro h.
  - apply Rle_ge, Rmult_le_compat_r; [left; pos | lra].
  - apply Rle_ge, Rmult_le_reg_r with (/ mu); [pos | unfold Rdiv in h; lra].
  - now rewrite h.
  - apply Rmult_eq_reg_r with (/ mu); [exact h | pos].
Qed.

Theorem b_insert_each_defined : statements.b_insert_each_defined.
Proof. values. Qed.

Theorem b_insert : statements.b_insert.
Proof.
  start. destruct (b_insert_each a b mu H H0 H1 e e e H2 H2 H2) as [order same].
  replace ((1 + e) * (1 + e) / (1 + e)) with (1 + e) in order, same by (field; pos).
  replace ((1 + e) ^ 2 * (1 + e) ^ 2 * a * b * mu ^ 2) with ((1 + e) ^ 4 * a * b * mu ^ 2) in order, same by ring.
  split; [| split].
  - rewrite order. split; intro; lra.
  - rewrite same. split; intro; lra.
  - field. repeat split; pos.
Qed.

Theorem b_insert_defined : statements.b_insert_defined.
Proof. values. Qed.

Theorem u3 : statements.u3.
Proof. start. split; (auto_derive; [| field]; pos). Qed.

Theorem u3_defined : statements.u3_defined.
Proof. start. split; [auto_derive |]; pos. Qed.

Lemma derivative_is : forall (f : R -> R) (x a b : R), is_derive f x a -> a = b -> is_derive f x b.
Proof. intros f x a b h <-. exact h. Qed.

Lemma first_derivative : forall m1 m2 k mu, m1 > 0 -> m2 > 0 -> mu > 0 ->
  is_derive (fun mu => k * mu ^ 2 / ((m1 + mu) ^ 2 * (mu + m2) ^ 2)) mu
    (2 * k * mu * (m1 * m2 - mu ^ 2) / ((m1 + mu) ^ 3 * (mu + m2) ^ 3)).
Proof. intros m1 m2 k mu h1 h2 h. auto_derive; [pos | field; lra]. Qed.

Theorem u5 : statements.u5.
Proof.
  start. split; (eapply derivative_is; [apply (first_derivative m1 m2); assumption | field; lra]).
Qed.

Theorem u5_defined : statements.u5_defined.
Proof. start. repeat split; [auto_derive | |]; pos. Qed.

Theorem u5_extracted : statements.u5_extracted.
Proof.
  start. intro h. specialize (h 1 1 2 ltac:(lra) ltac:(lra) ltac:(lra) 0 0 ltac:(lra) ltac:(lra)). cbv zeta in h.
  apply is_derive_unique in h.
  assert (g : is_derive (fun x : R => (1 + 0) ^ 2 * (1 + 0) ^ 2 * (x * 1) * 1 * 1 ^ 2 / ((x * 1 + 1) ^ 2 * (1 + 1) ^ 2)) 2
    (- 1 / 108)) by (auto_derive; [lra | field]).
  apply is_derive_unique in g. rewrite g in h. lra.
Qed.

Lemma second_derivative : forall m1 m2 k mu, m1 > 0 -> m2 > 0 -> mu > 0 ->
  is_derive_n (fun mu => k * mu ^ 2 / ((m1 + mu) ^ 2 * (mu + m2) ^ 2)) 2 mu
    (2 * k * ((m1 * m2 - 3 * mu ^ 2) * (m1 + mu) * (mu + m2) - 3 * mu * (m1 * m2 - mu ^ 2) * (m1 + m2 + 2 * mu))
      / ((m1 + mu) ^ 4 * (mu + m2) ^ 4)).
Proof.
  intros m1 m2 k mu h1 h2 h. unfold is_derive_n. unfold Derive_n.
  apply is_derive_ext_loc with (fun t => 2 * k * t * (m1 * m2 - t ^ 2) / ((m1 + t) ^ 3 * (t + m2) ^ 3)).
  - exists (mkposreal mu h). intros t ht. symmetry. apply is_derive_unique. apply first_derivative; try assumption.
    unfold ball in ht; cbn in ht. unfold AbsRing_ball, abs, minus, plus, opp in ht; cbn in ht.
    apply Rabs_def2 in ht. lra.
  - auto_derive; [pos | field; lra].
Qed.

Theorem u6 : statements.u6.
Proof.
  start. set (k := (1 + e1) ^ 2 * (1 + e2) ^ 2 * m1 * m2). assert (hk : 0 < k) by (unfold k; pos). split.
  - replace (2 * (1 + e1) ^ 2 * (1 + e2) ^ 2 * m1 * m2) with (2 * k) by (unfold k; ring).
    now apply second_derivative.
  - destruct (square_root m1 H) as (a & ha & h1 & _). destruct (square_root m2 H0) as (b & hb & h2 & _).
    replace (2 * (1 + e1) ^ 2 * (1 + e2) ^ 2 * m1 * m2) with (2 * k) by (unfold k; ring). clearbody k.
    rewrite h1, h2, sqrt_product by assumption.
    match goal with |- ?x < 0 => replace x with (- (2 * (2 * k) * (a * b) ^ 2 * ((a ^ 2 + a * b) * (a * b + b ^ 2))
      / ((a ^ 2 + a * b) ^ 4 * (a * b + b ^ 2) ^ 4))) by (field; split; apply Rgt_not_eq; nra) end.
    apply Ropp_lt_gt_0_contravar. apply Rlt_gt. pos.
Qed.

Theorem u6_defined : statements.u6_defined.
Proof.
  start. split.
  - eexists. apply second_derivative; assumption.
  - repeat split; pos.
Qed.

(** ** Roots of (1 + e) above and below *)

Theorem u7 : statements.u7.
Proof.
  start. assert (0 < sqrt m1) by pos. assert (0 < sqrt m2) by pos. repeat split; field; lra.
Qed.

Theorem u7_defined : statements.u7_defined.
Proof. values. Qed.

Lemma root_of_ratio : forall a b, 0 < a -> 0 < b -> sqrt (a ^ 2 / b ^ 2) = a / b.
Proof.
  intros a b ha hb. replace (a ^ 2 / b ^ 2) with ((a / b) ^ 2) by (field; lra). apply sqrt_pow2. left; pos.
Qed.

Theorem u8 : statements.u8.
Proof.
  start. destruct (square_root m1 H) as (a & ha & h1 & ->). destruct (square_root m2 H0) as (b & hb & h2 & ->).
  rewrite h1, h2. replace (4 * (a ^ 2 + b ^ 2) ^ 2 / (a + b) ^ 4)
    with ((2 * (a ^ 2 + b ^ 2)) ^ 2 / ((a + b) ^ 2) ^ 2) by (field; lra).
  rewrite root_of_ratio by pos.
  assert (q : 2 * (a ^ 2 + b ^ 2) / (a + b) ^ 2 - 1 = ((a - b) / (a + b)) ^ 2) by (field; lra).
  rewrite q. split; [reflexivity | apply Rle_ge, pow2_ge_0].
Qed.

Theorem u8_defined : statements.u8_defined.
Proof. values. Qed.

Lemma sqrt_4 : sqrt 4 = 2.
Proof. replace 4 with (2 ^ 2) by ring. apply sqrt_pow2. lra. Qed.

Theorem u8_extracted : statements.u8_extracted.
Proof.
  start. intro h. specialize (h 4 1 ltac:(lra) ltac:(lra)). cbv zeta in h. rewrite sqrt_4, sqrt_1 in h.
  field_simplify in h. lra.
Qed.

Theorem u9 : statements.u9.
Proof.
  start. destruct (square_root m1 H) as (a & ha & h1 & ->). destruct (square_root m2 H0) as (b & hb & h2 & ->).
  rewrite h1, h2, sqrt_product by assumption.
  replace ((a ^ 2 + b ^ 2) ^ 2 / (a + b) ^ 4) with ((a ^ 2 + b ^ 2) ^ 2 / ((a + b) ^ 2) ^ 2) by (field; lra).
  rewrite root_of_ratio by pos.
  assert (q : (a ^ 2 + b ^ 2) / (a + b) ^ 2 - 1 = - (2 * (a * b) / (a + b) ^ 2)) by (field; lra).
  rewrite q. split; [reflexivity |]. assert (0 < 2 * (a * b) / (a + b) ^ 2) by pos. lra.
Qed.

Theorem u9_defined : statements.u9_defined.
Proof. values. Qed.

Theorem u9_extracted : statements.u9_extracted.
Proof.
  start. intro h. specialize (h 4 1 ltac:(lra) ltac:(lra)). cbv zeta in h.
  rewrite Rmult_1_r, sqrt_4, sqrt_1 in h. field_simplify in h. lra.
Qed.

Theorem u10 : statements.u10.
Proof.
  start. destruct (square_root m1 H) as (a & ha & h1 & ->). destruct (square_root m2 H0) as (b & hb & h2 & ->).
  rewrite h1, h2.
  replace ((1 + e1) ^ 2 * (1 + e2) ^ 2 * a ^ 2 * b ^ 2 / (a + b) ^ 4)
    with (a ^ 2 * b ^ 2 * ((1 + e1) * (1 + e2)) ^ 2 / ((a + b) ^ 2) ^ 2) by (field; lra).
  replace ((1 + e) ^ 2 * a ^ 2 * b ^ 2) with (a ^ 2 * b ^ 2 * (1 + e) ^ 2) by ring.
  apply shares_compared; pos.
Qed.

Theorem u10_defined : statements.u10_defined.
Proof. values. Qed.

(** ** Four bodies *)

Theorem eq16 : statements.eq16.
Proof. start. field. lra. Qed.

Theorem eq16_defined : statements.eq16_defined.
Proof. values. Qed.

Lemma stationary : forall (f : R -> R) (x d c z : R), is_derive f x d -> d = c * z -> c <> 0 -> (is_derive f x 0 <-> z = 0).
Proof.
  intros f x d c z h e hc. split; intro g.
  - apply is_derive_unique in h. apply is_derive_unique in g. apply (product_zero c z hc). congruence.
  - rewrite g, Rmult_0_r in e. now rewrite e in h.
Qed.

Lemma mean_of : forall x a b, 0 < x -> 0 < a -> 0 < b -> (a * b - x ^ 2 = 0 <-> x = sqrt (a * b)).
Proof.
  intros x a b hx ha hb. split; intro h.
  - replace (a * b) with (x ^ 2) by lra. symmetry. apply sqrt_pow2. lra.
  - rewrite h. rewrite <- (sqrt_sqrt (a * b)) at 1 by pos. ring.
Qed.

Theorem u11 : statements.u11.
Proof.
  start. set (k := (1 + e1) ^ 2 * (1 + e2) ^ 2 * (1 + e3) ^ 2 * m1 * m2).
  assert (hk : 0 < k) by (unfold k; pos).
  assert (one : is_derive (fun mu1 : R => k * mu1 ^ 2 * mu2 ^ 2 / ((m1 + mu1) ^ 2 * (mu1 + mu2) ^ 2 * (mu2 + m2) ^ 2)) mu1 0
    <-> m1 * mu2 - mu1 ^ 2 = 0).
  { eapply (stationary _ _ _ (2 * k * mu1 * mu2 ^ 2 / ((m1 + mu1) ^ 3 * (mu1 + mu2) ^ 3 * (mu2 + m2) ^ 2))).
    - auto_derive; [pos | reflexivity].
    - field. lra.
    - pos. }
  assert (two : is_derive (fun mu2 : R => k * mu1 ^ 2 * mu2 ^ 2 / ((m1 + mu1) ^ 2 * (mu1 + mu2) ^ 2 * (mu2 + m2) ^ 2)) mu2 0
    <-> mu1 * m2 - mu2 ^ 2 = 0).
  { eapply (stationary _ _ _ (2 * k * mu2 * mu1 ^ 2 / ((m1 + mu1) ^ 2 * (mu1 + mu2) ^ 3 * (mu2 + m2) ^ 3))).
    - auto_derive; [pos | reflexivity].
    - field. lra.
    - pos. }
  rewrite one, two. repeat split; intro h; try lra; apply (mean_of) in h; try assumption; lra.
Qed.

Theorem u11_defined : statements.u11_defined.
Proof. start. repeat split; try (auto_derive; pos); pos. Qed.
