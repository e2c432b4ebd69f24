(** The weighted mean inequality for two values, from exp s >= 1 + s alone, and what a chain of
    links makes of it. *)

From Carom Require Import vocabulary.
From Coq Require Import Lra Lia.

(** ** Positivity *)

Lemma Rpower_pos : forall x y, 0 < Rpower x y.
Proof. intros; apply exp_pos. Qed.

Lemma INR_pos : forall n, (n >= 1)%nat -> 0 < INR n.
Proof. intros n h. change 0 with (INR 0). apply lt_INR. lia. Qed.

(** Shows that an expression built from positive parts is positive. *)
Ltac pos :=
  lazymatch goal with
  | |- _ > _ => apply Rlt_gt; pos
  | |- _ <> 0 => apply Rgt_not_eq; pos
  | |- _ <= _ => apply Rlt_le; pos
  | |- _ >= _ => apply Rle_ge, Rlt_le; pos
  | |- 0 < _ * _ => first [assumption | apply Rmult_lt_0_compat; pos]
  | |- 0 < _ / _ => apply Rdiv_lt_0_compat; pos
  | |- 0 < / _ => apply Rinv_0_lt_compat; pos
  | |- 0 < _ ^ _ => apply pow_lt; pos
  | |- 0 < exp _ => apply exp_pos
  | |- 0 < Rpower _ _ => apply exp_pos
  | |- 0 < cbrt _ => apply exp_pos
  | |- 0 < sqrt _ => apply sqrt_lt_R0; pos
  | |- 0 < INR (S _) => apply lt_0_INR; lia
  | |- 0 < INR _ => apply lt_0_INR; lia
  | |- 0 < INR _ + _ => apply Rplus_le_lt_0_compat; [apply pos_INR | pos]
  | |- 0 < _ + _ => first [lra | apply Rplus_lt_0_compat; pos]
  | |- _ => first
      [ assumption
      | match goal with h : (forall k, ?f k > 0) |- 0 < ?f _ => apply h end
      | lra
      | solve [auto with real] ]
  end.

(** ** From the exponential function to the mean *)

Lemma mean_exp : forall p s, 0 <= p <= 1 -> exp (p * s) <= (1 - p) + p * exp s.
Proof.
  intros p s hp.
  assert (h : exp (p * s) * ((1 - p) * exp (- (p * s)) + p * exp ((1 - p) * s)) = (1 - p) + p * exp s).
  { rewrite Rmult_plus_distr_l.
    replace (exp (p * s) * ((1 - p) * exp (- (p * s)))) with ((1 - p) * (exp (p * s) * exp (- (p * s)))) by ring.
    replace (exp (p * s) * (p * exp ((1 - p) * s))) with (p * (exp (p * s) * exp ((1 - p) * s))) by ring.
    rewrite <- !exp_plus. replace (p * s + - (p * s)) with 0 by ring.
    replace (p * s + (1 - p) * s) with s by ring. rewrite exp_0. ring. }
  rewrite <- h. rewrite <- (Rmult_1_r (exp (p * s))) at 1.
  apply Rmult_le_compat_l; [left; apply exp_pos |].
  assert (a := exp_ineq1_le (- (p * s))). assert (b := exp_ineq1_le ((1 - p) * s)).
  apply Rle_trans with ((1 - p) * (1 + - (p * s)) + p * (1 + (1 - p) * s)); [right; ring |].
  apply Rplus_le_compat; apply Rmult_le_compat_l; lra.
Qed.

Lemma mean_exp_strict : forall p s, 0 < p < 1 -> s <> 0 -> exp (p * s) < (1 - p) + p * exp s.
Proof.
  intros p s hp hs.
  assert (h : exp (p * s) * ((1 - p) * exp (- (p * s)) + p * exp ((1 - p) * s)) = (1 - p) + p * exp s).
  { rewrite Rmult_plus_distr_l.
    replace (exp (p * s) * ((1 - p) * exp (- (p * s)))) with ((1 - p) * (exp (p * s) * exp (- (p * s)))) by ring.
    replace (exp (p * s) * (p * exp ((1 - p) * s))) with (p * (exp (p * s) * exp ((1 - p) * s))) by ring.
    rewrite <- !exp_plus. replace (p * s + - (p * s)) with 0 by ring.
    replace (p * s + (1 - p) * s) with s by ring. rewrite exp_0. ring. }
  rewrite <- h. rewrite <- (Rmult_1_r (exp (p * s))) at 1.
  apply Rmult_lt_compat_l; [apply exp_pos |].
  assert (a : 1 + - (p * s) < exp (- (p * s))).
  { apply exp_ineq1. intro z. apply hs. apply Rmult_eq_reg_l with p; lra. }
  assert (b := exp_ineq1_le ((1 - p) * s)).
  apply Rle_lt_trans with ((1 - p) * (1 + - (p * s)) + p * (1 + (1 - p) * s)); [right; ring |].
  apply Rplus_lt_le_compat; [apply Rmult_lt_compat_l | apply Rmult_le_compat_l]; lra.
Qed.

(** ** A sum of two lies above its tangent in powers *)

Lemma tangent : forall a b r, a > 0 -> b > 0 -> r > 0 ->
  a + b >= a * (1 + r) * Rpower (b / (a * r)) (r / (1 + r)).
Proof.
  intros a b r ha hb hr. set (p := r / (1 + r)). set (t := b / (a * r)).
  assert (ht : 0 < t) by (unfold t; pos).
  assert (hp : 0 < p < 1).
  { split; [unfold p; pos | unfold p; apply Rmult_lt_reg_r with (1 + r); [lra |]; field_simplify; lra]. }
  assert (h : Rpower t p <= (1 - p) + p * t).
  { unfold Rpower. rewrite <- (exp_ln t) at 2 by exact ht. apply mean_exp; lra. }
  apply Rle_ge. apply Rle_trans with (a * (1 + r) * ((1 - p) + p * t)).
  - apply Rmult_le_compat_l; [pos | exact h].
  - right. unfold p, t. field. lra.
Qed.

Lemma tangent_strict : forall a b r, a > 0 -> b > 0 -> r > 0 -> b <> a * r ->
  a + b > a * (1 + r) * Rpower (b / (a * r)) (r / (1 + r)).
Proof.
  intros a b r ha hb hr hd. set (p := r / (1 + r)). set (t := b / (a * r)).
  assert (ht : 0 < t) by (unfold t; pos).
  assert (hp : 0 < p < 1).
  { split; [unfold p; pos | unfold p; apply Rmult_lt_reg_r with (1 + r); [lra |]; field_simplify; lra]. }
  assert (hl : ln t <> 0).
  { intro z. rewrite <- ln_1 in z. apply ln_inv in z; [| exact ht | lra]. apply hd.
    assert (par : 0 < a * r) by pos.
    apply Rmult_eq_reg_r with (/ (a * r)); [| pos]. transitivity t; [reflexivity | rewrite z; field; lra]. }
  assert (h : Rpower t p < (1 - p) + p * t).
  { unfold Rpower. rewrite <- (exp_ln t) at 2 by exact ht. apply mean_exp_strict; assumption. }
  apply Rlt_gt. apply Rlt_le_trans with (a * (1 + r) * ((1 - p) + p * t)).
  - apply Rmult_lt_compat_l; [pos | exact h].
  - right. unfold p, t. field. lra.
Qed.

(** The same without a quotient under the power. *)
Lemma link : forall a b r p, a > 0 -> b > 0 -> r > 0 -> p = r / (1 + r) ->
  (a + b) * Rpower a p * Rpower r p >= a * (1 + r) * Rpower b p.
Proof.
  intros a b r p ha hb hr hp.
  assert (e : Rpower b p = Rpower (b / (a * r)) p * (Rpower a p * Rpower r p)).
  { rewrite (Rpower_mult_distr a r) by assumption. rewrite Rpower_mult_distr; [| pos | pos].
    f_equal. field. lra. }
  rewrite e. assert (t := tangent a b r ha hb hr). rewrite <- hp in t.
  assert (q : 0 < Rpower a p * Rpower r p) by pos.
  apply Rle_ge. apply Rge_le in t. apply (Rmult_le_compat_r _ _ _ (Rlt_le _ _ q)) in t. lra.
Qed.

Lemma link_strict : forall a b r p, a > 0 -> b > 0 -> r > 0 -> p = r / (1 + r) -> b <> a * r ->
  (a + b) * Rpower a p * Rpower r p > a * (1 + r) * Rpower b p.
Proof.
  intros a b r p ha hb hr hp hd.
  assert (e : Rpower b p = Rpower (b / (a * r)) p * (Rpower a p * Rpower r p)).
  { rewrite (Rpower_mult_distr a r) by assumption. rewrite Rpower_mult_distr; [| pos | pos].
    f_equal. field. lra. }
  rewrite e. assert (t := tangent_strict a b r ha hb hr hd). rewrite <- hp in t.
  assert (q : 0 < Rpower a p * Rpower r p) by pos.
  apply (Rmult_lt_compat_r _ _ _ q) in t. lra.
Qed.
