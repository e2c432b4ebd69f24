(** Two bodies: the laws of a collision, what follows from them, and the transfer matrix. *)

From Carom Require Import vocabulary weighted_mean tactics.
From Carom Require statements.
From Coq Require Import Lra Lia.

(** The two laws have one solution. *)
Lemma solution : forall m1 m2 e v1 v2 w1 w2, m1 > 0 -> m2 > 0 ->
  m1 * v1 + m2 * v2 = m1 * w1 + m2 * w2 -> w2 - w1 = - (e * (v2 - v1)) ->
  w1 = (m1 - e * m2) / (m1 + m2) * v1 + m2 * (1 + e) / (m1 + m2) * v2 /\
  w2 = m1 * (1 + e) / (m1 + m2) * v1 + (m2 - e * m1) / (m1 + m2) * v2.
Proof.
  intros m1 m2 e v1 v2 w1 w2 h1 h2 p q.
  split; apply Rmult_eq_reg_l with (m1 + m2); try lra; field_simplify; try lra; nra.
Qed.

(** The energy lost, by the laws alone. *)
Lemma energy_lost : forall m1 m2 e v1 v2 w1 w2, m1 > 0 -> m2 > 0 ->
  m1 * v1 + m2 * v2 = m1 * w1 + m2 * w2 -> w2 - w1 = - (e * (v2 - v1)) ->
  m1 * v1 ^ 2 / 2 + m2 * v2 ^ 2 / 2 - m1 * w1 ^ 2 / 2 - m2 * w2 ^ 2 / 2
  = m1 * m2 * (1 - e ^ 2) * (v1 - v2) ^ 2 / (2 * (m1 + m2)).
Proof.
  intros m1 m2 e v1 v2 w1 w2 h1 h2 p q. destruct (solution m1 m2 e v1 v2 w1 w2 h1 h2 p q) as [-> ->].
  field. lra.
Qed.

Lemma product_zero : forall a b, a <> 0 -> (a * b = 0 <-> b = 0).
Proof. intros a b ha. split; intro h; [destruct (Rmult_integral _ _ h); tauto | rewrite h; ring]. Qed.

Theorem eq01 : statements.eq01.
Proof. start. lra. Qed.

Theorem eq02 : statements.eq02.
Proof.
  start. assert (l := energy_lost m1 m2 1 v1 v2 w1 w2 H H0 H1). rewrite Rmult_1_l in l.
  specialize (l ltac:(lra)). replace (1 - 1 ^ 2) with 0 in l by ring. field_simplify in l; lra.
Qed.

Theorem eq03 : statements.eq03.
Proof.
  start. assert (hd : m1 * (v1 - w1) <> 0) by (apply Rmult_integral_contrapositive; lra).
  apply Rminus_diag_uniq. apply (product_zero _ _ hd).
  assert (p : m1 * (v1 - w1) = m2 * (w2 - v2)) by lra.
  transitivity (m1 * (v1 - w1) * (v1 + w1) - m1 * (v1 - w1) * (v2 + w2)); [ring |].
  rewrite p at 2. lra.
Qed.

Theorem eq03_unguarded : statements.eq03_unguarded.
Proof. start. intro h. specialize (h 1 1 Rlt_0_1 Rlt_0_1 1 0 1 0). lra. Qed.

Theorem eq04 : statements.eq04.
Proof.
  start. assert (q : w2 - w1 = - (e * (v2 - v1))) by (rewrite H5; field; lra).
  assert (l := energy_lost m1 m2 e v1 v2 w1 w2 H H0 H3 q).
  assert (hp : 0 < m1 * m2 * (v1 - v2) ^ 2 / (2 * (m1 + m2))).
  { apply Rdiv_lt_0_compat; [| lra]. apply Rmult_lt_0_compat; [pos |]. apply pow2_gt_0. lra. }
  replace (m1 * m2 * (1 - e ^ 2) * (v1 - v2) ^ 2 / (2 * (m1 + m2)))
    with (m1 * m2 * (v1 - v2) ^ 2 / (2 * (m1 + m2)) * (1 - e ^ 2)) in l by (field; lra).
  split; intro h.
  - rewrite h in l. lra.
  - assert (z : 1 - e ^ 2 = 0) by (apply (product_zero (m1 * m2 * (v1 - v2) ^ 2 / (2 * (m1 + m2)))); lra).
    nra.
Qed.

Theorem eq05 : statements.eq05.
Proof. start. now destruct (solution m1 m2 e v1 v2 w1 w2 H H0 H2 H3). Qed.

Theorem eq05_defined : statements.eq05_defined.
Proof. values. Qed.

Theorem eq05_unique : statements.eq05_unique.
Proof.
  start. split.
  - intros [p q]. now apply solution.
  - intros [-> ->]. split; field; lra.
Qed.

Theorem eq05_unique_defined : statements.eq05_unique_defined.
Proof. values. Qed.

Theorem eq06 : statements.eq06.
Proof. start. now destruct (solution m1 m2 e v1 v2 w1 w2 H H0 H2 H3). Qed.

Theorem eq06_defined : statements.eq06_defined.
Proof. values. Qed.

(** Matrices are compared entry by entry. *)
Ltac entries := cbn; repeat (f_equal; []); repeat match goal with |- cons _ _ = cons _ _ => f_equal end.

Theorem eq07 : statements.eq07.
Proof.
  start. destruct (solution m1 m2 e v1 v2 w1 w2 H H0 H2 H3) as [-> ->].
  assert (0 < m1 / m2) by pos. split; entries; field; lra.
Qed.

Theorem eq07_defined : statements.eq07_defined.
Proof. values. Qed.

Theorem eq08 : statements.eq08.
Proof. start. field. lra. Qed.

Theorem eq08_defined : statements.eq08_defined.
Proof. values. Qed.

Theorem eq09 : statements.eq09.
Proof. start. field. lra. Qed.

Theorem eq09_defined : statements.eq09_defined.
Proof. values. Qed.

(** (1 + x)^2 - (1 + e)^2 x is a sum of two terms that are not negative. *)
Lemma whole_share : forall x e, x > 0 -> 0 <= e <= 1 -> (1 + x) ^ 2 - (1 + e) ^ 2 * x = 0 <-> e = 1 /\ x = 1.
Proof.
  intros x e hx he. split.
  - intro h. assert (s : (x - 1) ^ 2 + (1 - e) * (3 + e) * x = 0) by (rewrite <- h; ring).
    assert (a := pow2_ge_0 (x - 1)).
    assert (b : 0 <= (1 - e) * (3 + e) * x) by (repeat apply Rmult_le_pos; lra).
    assert (c : (x - 1) ^ 2 = 0) by lra. assert (d : (1 - e) * (3 + e) * x = 0) by lra.
    split.
    + destruct (Rmult_integral _ _ d) as [d' | d']; [| lra]. destruct (Rmult_integral _ _ d'); lra.
    + assert (x - 1 = 0) by nra. lra.
  - intros [-> ->]. ring.
Qed.

Theorem eq10 : statements.eq10.
Proof.
  start. assert (one : (1 + e) ^ 2 * x / (1 + x) ^ 2 = 1 <-> (1 + x) ^ 2 - (1 + e) ^ 2 * x = 0).
  { rewrite quotient_one by pos. split; intro; lra. }
  assert (s := whole_share x e H H0). split.
  - rewrite one. destruct (square_root x H) as (a & ha & hx & ->). rewrite hx.
    replace ((1 + a ^ 2) ^ 2 - (1 + e) ^ 2 * a ^ 2) with ((a ^ 2 + (1 + e) * a + 1) * (a ^ 2 - (1 + e) * a + 1)) by ring.
    apply product_zero. assert (0 < a ^ 2) by pos. assert (0 < (1 + e) * a) by pos. lra.
  - now rewrite one.
Qed.

Theorem eq10_defined : statements.eq10_defined.
Proof. values. Qed.

Theorem eq10_extracted : statements.eq10_extracted.
Proof.
  start. intro h. specialize (h 2 ltac:(lra) (1 / 2) ltac:(lra)). destruct h as [_ h].
  assert (z : 2 - (1 + 1 / 2) * 2 + 1 = 0) by field. specialize (h z). field_simplify in h. lra.
Qed.

Theorem eq10_roots : statements.eq10_roots.
Proof.
  start. split.
  - transitivity (y ^ 2 - (1 + e) * y + ((1 + e) ^ 2 - s ^ 2) / 4); [rewrite H; field | field].
  - split; intro h.
    + destruct (Rmult_integral _ _ h); [left | right]; lra.
    + destruct h as [-> | ->]; ring.
Qed.

Theorem eq11 : statements.eq11.
Proof.
  start. split; [lra |]. split; [field |]. intros x hx.
  assert (e2 : 0 < (1 + e) ^ 2) by pos.
  assert (d : (1 + e) ^ 2 / 4 - (1 + e) ^ 2 * x / (1 + x) ^ 2 = (1 + e) ^ 2 * (x - 1) ^ 2 / (4 * (1 + x) ^ 2))
    by (field; lra).
  assert (q : 0 < 4 * (1 + x) ^ 2) by pos.
  split.
  - assert (0 <= (1 + e) ^ 2 * (x - 1) ^ 2 / (4 * (1 + x) ^ 2)).
    { apply Rmult_le_pos; [apply Rmult_le_pos; [lra | apply pow2_ge_0] | left; pos]. }
    lra.
  - intro h. rewrite h, Rminus_diag_eq in d by reflexivity.
    assert (z : (x - 1) ^ 2 = 0).
    { apply (product_zero ((1 + e) ^ 2 / (4 * (1 + x) ^ 2))); [pos | rewrite d; field; lra]. }
    assert (x - 1 = 0) by nra. lra.
Qed.

Theorem eq11_defined : statements.eq11_defined.
Proof. values. Qed.

Theorem p_loss : statements.p_loss.
Proof.
  start. rewrite (energy_lost m1 m2 e v1 v2 w1 w2 H H0 H2 H3). split; [reflexivity |].
  assert (q : 0 < 2 * (m1 + m2)) by lra. assert (m : 0 < m1 * m2) by pos.
  assert (e2 : 0 <= 1 - e ^ 2) by nra. assert (s := pow2_ge_0 (v1 - v2)). split.
  - apply Rle_ge. apply Rmult_le_pos; [| left; pos]. apply Rmult_le_pos; [apply Rmult_le_pos; lra | exact s].
  - assert (c : 0 < m1 * m2 / (2 * (m1 + m2))) by pos.
    replace (m1 * m2 * (1 - e ^ 2) * (v1 - v2) ^ 2 / (2 * (m1 + m2)))
      with (m1 * m2 / (2 * (m1 + m2)) * ((1 - e ^ 2) * (v1 - v2) ^ 2)) by (field; lra).
    rewrite product_zero by lra. split; intro h.
    + destruct (Rmult_integral _ _ h); [left; nra | right; nra].
    + destruct h as [-> | ->]; ring.
Qed.

Theorem p_loss_defined : statements.p_loss_defined.
Proof. values. Qed.

Theorem p_order : statements.p_order.
Proof. start. nra. Qed.

Theorem p_frame : statements.p_frame.
Proof.
  start. destruct (solution m1 m2 e v1 v2 w1 w2 H H0 H2 H3) as [-> ->].
  split; [| entries]; field; lra.
Qed.

Theorem p_frame_defined : statements.p_frame_defined.
Proof. values. Qed.

Theorem p_frame_energy : statements.p_frame_energy.
Proof.
  start. exists 0. split; [lra |]. exists 1, 1. split; [lra |]. split; [lra |]. exists 1, 0, 1.
  repeat split; lra.
Qed.

Theorem p_full : statements.p_full.
Proof.
  start. assert (x : 0 < m1 / m2) by pos. assert (s := whole_share (m1 / m2) e x H1).
  assert (one : (1 + e) ^ 2 * m1 * m2 / (m1 + m2) ^ 2 = 1 <-> (1 + m1 / m2) ^ 2 - (1 + e) ^ 2 * (m1 / m2) = 0).
  { replace ((1 + m1 / m2) ^ 2 - (1 + e) ^ 2 * (m1 / m2))
      with (/ m2 ^ 2 * ((m1 + m2) ^ 2 - (1 + e) ^ 2 * m1 * m2)) by (field; lra).
    rewrite product_zero by pos. rewrite quotient_one by pos. split; intro; lra. }
  rewrite one, s. split; intros [he h]; split; try exact he.
  - apply Rmult_eq_reg_r with (/ m2); [| pos]. replace (m2 * / m2) with 1 by (field; lra). exact h.
  - rewrite h. field. lra.
Qed.

Theorem p_full_defined : statements.p_full_defined.
Proof. values. Qed.

Theorem p_rest : statements.p_rest.
Proof.
  start. assert (a : 0 < v1 / (x + 1)) by pos.
  assert (b : 0 < (x * (1 + e)) ^ i / (x + 1) ^ (i + 1) * v1).
  { apply Rmult_lt_0_compat; [| lra]. apply Rdiv_lt_0_compat; apply pow_lt; [| lra]. apply Rmult_lt_0_compat; lra. }
  split.
  - replace ((x - e) / (x + 1) * v1) with (v1 / (x + 1) * (x - e)) by (field; lra).
    rewrite product_zero by lra. split; intro; lra.
  - replace ((x * (1 + e)) ^ i * (x - e) / (x + 1) ^ (i + 1) * v1)
      with ((x * (1 + e)) ^ i / (x + 1) ^ (i + 1) * v1 * (x - e)) by (field; apply pow_nonzero; lra).
    rewrite product_zero by lra. split; intro; lra.
Qed.

Theorem p_rest_defined : statements.p_rest_defined.
Proof. values. Qed.

Theorem p_stop : statements.p_stop.
Proof.
  start. assert (a : 0 < v1 / (m1 + m2)) by pos. split; [| split; [| split]].
  - replace ((m1 - e * m2) / (m1 + m2) * v1) with (v1 / (m1 + m2) * (m1 - e * m2)) by (field; lra).
    rewrite product_zero by lra. split; intro; lra.
  - intros ->. field. lra.
  - assert (s := pow2_ge_0 (1 - e)). nra.
  - split; intro h; [assert (s := pow2_ge_0 (1 - e)); nra | rewrite h; field].
Qed.

Theorem p_stop_defined : statements.p_stop_defined.
Proof. values. Qed.

Theorem u1 : statements.u1.
Proof. start. split; nra. Qed.

Theorem u2 : statements.u2.
Proof. start. split; field; lra. Qed.

Theorem u2_defined : statements.u2_defined.
Proof. values. Qed.

Theorem u4 : statements.u4.
Proof. start. destruct (solution m1 mu e1 v1 v w1 w H H0 H2 H3) as [-> ->]. entries; field; lra. Qed.

Theorem u4_defined : statements.u4_defined.
Proof. values. Qed.

Theorem b_matrix : statements.b_matrix.
Proof. start. repeat split; entries; field; lra. Qed.

Theorem b_matrix_defined : statements.b_matrix_defined.
Proof. values. Qed.
