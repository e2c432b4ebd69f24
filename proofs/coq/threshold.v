(** The sums (m1^(1/k) + m2^(1/k))^k, of which shares and thresholds are made: they rise with k,
    less than double, and each is at most the geometric mean of its neighbours. *)

From Carom Require Import vocabulary weighted_mean chain.
From Coq Require Import Lra Lia.

(** A_k = (m1^(1/k) + m2^(1/k))^k. *)
Definition amount (m1 m2 : R) (k : nat) : R := (Rpower m1 (1 / INR k) + Rpower m2 (1 / INR k)) ^ k.

Section Amount.
Variables m1 m2 : R.
Hypotheses (h1 : m1 > 0) (h2 : m2 > 0).

Lemma amount_pos : forall k, 0 < amount m1 m2 k.
Proof. intro k. unfold amount. apply pow_lt. apply Rplus_lt_0_compat; apply exp_pos. Qed.

Let D := m2 / m1.

Lemma D_pos : 0 < D.
Proof. unfold D. pos. Qed.

Lemma amount_ratio : forall k, (k >= 1)%nat -> amount m1 m2 k = m1 * (1 + Rpower D (1 / INR k)) ^ k.
Proof.
  intros k hk. unfold amount, D. rewrite root_sum by assumption. rewrite Rpow_mult_distr.
  now rewrite root_power.
Qed.

Lemma power_of_power : forall x y k, 0 < x -> Rpower x y ^ k = Rpower (x ^ k) y.
Proof.
  intros x y k hx. rewrite <- !Rpower_pow by pos. rewrite !Rpower_mult. f_equal. ring.
Qed.

(** The tangent at r, raised to the power k; t^k is D or, for t = 1, 1. *)
Lemma tangent_power : forall t r k, t > 0 -> r > 0 ->
  (1 + t) ^ k >= (1 + r) ^ k * Rpower (t ^ k / r ^ k) (r / (1 + r)).
Proof.
  intros t r k ht hr. assert (l := tangent 1 t r Rlt_0_1 ht hr).
  replace (Rpower (t ^ k / r ^ k) (r / (1 + r))) with (Rpower (t / (1 * r)) (r / (1 + r)) ^ k).
  - rewrite <- Rpow_mult_distr. apply Rle_ge, pow_incr. split; [| lra]. left. pos.
  - assert (q : 0 < t / (1 * r)) by pos. rewrite power_of_power by exact q. f_equal.
    unfold Rdiv. rewrite Rmult_1_l, Rpow_mult_distr, pow_inv. reflexivity.
Qed.

Lemma tangent_power_strict : forall t r k, t > 0 -> r > 0 -> t <> r -> (k >= 1)%nat ->
  (1 + t) ^ k > (1 + r) ^ k * Rpower (t ^ k / r ^ k) (r / (1 + r)).
Proof.
  intros t r k ht hr hd hk.
  assert (hd' : t <> 1 * r) by lra.
  assert (l := tangent_strict 1 t r Rlt_0_1 ht hr hd').
  replace (Rpower (t ^ k / r ^ k) (r / (1 + r))) with (Rpower (t / (1 * r)) (r / (1 + r)) ^ k).
  - rewrite <- Rpow_mult_distr.
    assert (low : 0 < (1 + r) * Rpower (t / (1 * r)) (r / (1 + r))) by pos.
    set (b := (1 + r) * _) in *. assert (hb : b < 1 + t) by (unfold b; lra). clearbody b. clear l.
    destruct k as [| k]; [lia |]. clear hk. induction k as [| k ih]; [lra |].
    rewrite <- (tech_pow_Rmult (1 + t)), <- (tech_pow_Rmult b).
    apply Rmult_gt_0_lt_compat; [apply pow_lt; lra | lra | exact hb | exact ih].
  - assert (q : 0 < t / (1 * r)) by pos. rewrite power_of_power by exact q. f_equal.
    unfold Rdiv. rewrite Rmult_1_l, Rpow_mult_distr, pow_inv. reflexivity.
Qed.

Lemma root_inj : forall x y, x > 0 -> x <> 1 -> Rpower x y = 1 -> y = 0.
Proof.
  intros x y hx hn h. unfold Rpower in h. rewrite <- exp_0 in h. apply exp_inv in h.
  destruct (Rmult_integral _ _ h) as [z | z]; [exact z |]. exfalso. apply hn.
  rewrite <- ln_1 in z. apply ln_inv in z; lra.
Qed.

Lemma roots_differ : forall x y z, x > 0 -> x <> 1 -> y <> z -> Rpower x y <> Rpower x z.
Proof.
  intros x y z hx hn hd h. apply hd. apply Rminus_diag_uniq.
  apply root_inj with x; [exact hx | exact hn |]. unfold Rminus. rewrite Rpower_plus, Rpower_Ropp, h.
  field. pos.
Qed.

Section Convex.
Variable k : nat.
Hypothesis hk : (k >= 1)%nat.

Let r := Rpower D (1 / INR (k + 1)).
Let p := r / (1 + r).

Lemma exponents_cancel : Rpower (D / r ^ k) p * Rpower (D / r ^ (k + 2)) p = 1.
Proof.
  assert (hD := D_pos). assert (hr : 0 < r) by (unfold r; pos).
  assert (e : r ^ (k + 1) = D) by (unfold r; apply root_power; [exact hD | lia]).
  rewrite Rpower_mult_distr; [| pos | pos].
  replace (D / r ^ k * (D / r ^ (k + 2))) with 1.
  - unfold Rpower. rewrite ln_1, Rmult_0_r. apply exp_0.
  - rewrite <- e. rewrite !pow_add. field. split; pos.
Qed.

Lemma amount_log_convex : amount m1 m2 (k + 1) ^ 2 <= amount m1 m2 k * amount m1 m2 (k + 2).
Proof.
  assert (hD := D_pos). assert (hr : 0 < r) by (unfold r; pos).
  rewrite !amount_ratio by lia. fold r.
  set (s := Rpower D (1 / INR k)). set (t := Rpower D (1 / INR (k + 2))).
  assert (hs : s > 0) by (unfold s; pos). assert (ht : t > 0) by (unfold t; pos).
  assert (es : s ^ k = D) by (unfold s; apply root_power; [exact hD | exact hk]).
  assert (et : t ^ (k + 2) = D) by (unfold t; apply root_power; [exact hD | lia]).
  assert (a := tangent_power s r k hs hr). assert (b := tangent_power t r (k + 2) ht hr).
  rewrite es in a. rewrite et in b. fold p in a, b.
  assert (c := exponents_cancel).
  set (u := Rpower (D / r ^ k) p) in *. set (w := Rpower (D / r ^ (k + 2)) p) in *.
  assert (hu : 0 < u) by apply exp_pos. assert (hw : 0 < w) by apply exp_pos.
  replace (m1 * (1 + s) ^ k * (m1 * (1 + t) ^ (k + 2))) with (m1 ^ 2 * ((1 + s) ^ k * (1 + t) ^ (k + 2))) by ring.
  replace ((m1 * (1 + r) ^ (k + 1)) ^ 2) with (m1 ^ 2 * ((1 + r) ^ k * (1 + r) ^ (k + 2)))
    by (rewrite !pow_add; ring).
  apply Rmult_le_compat_l; [pos |].
  apply Rge_le in a. apply Rge_le in b.
  assert (h : (1 + r) ^ k * u * ((1 + r) ^ (k + 2) * w) <= (1 + s) ^ k * (1 + t) ^ (k + 2)).
  { apply Rmult_le_compat; try assumption; left; pos. }
  replace ((1 + r) ^ k * (1 + r) ^ (k + 2)) with ((1 + r) ^ k * u * ((1 + r) ^ (k + 2) * w)); [exact h |].
  transitivity ((1 + r) ^ k * (1 + r) ^ (k + 2) * (u * w)); [ring | rewrite c; ring].
Qed.

Lemma amount_log_convex_strict : m1 <> m2 -> amount m1 m2 (k + 1) ^ 2 < amount m1 m2 k * amount m1 m2 (k + 2).
Proof.
  intro hd. assert (hD := D_pos). assert (hr : 0 < r) by (unfold r; pos).
  assert (hD1 : D <> 1).
  { unfold D. intro z. apply hd. apply Rmult_eq_reg_r with (/ m1); [| pos]. unfold Rdiv in z. rewrite z. field. lra. }
  rewrite !amount_ratio by lia. fold r.
  set (s := Rpower D (1 / INR k)). set (t := Rpower D (1 / INR (k + 2))).
  assert (hs : s > 0) by (unfold s; pos). assert (ht : t > 0) by (unfold t; pos).
  assert (es : s ^ k = D) by (unfold s; apply root_power; [exact hD | exact hk]).
  assert (et : t ^ (k + 2) = D) by (unfold t; apply root_power; [exact hD | lia]).
  assert (sr : s <> r).
  { apply roots_differ; [exact hD | exact hD1 |]. intro z. apply (f_equal (fun x => x * INR k * INR (k + 1))) in z.
    assert (ik := INR_pos k hk). rewrite plus_INR in z. simpl INR in z. field_simplify in z; [| lra | lra]. lra. }
  assert (a := tangent_power_strict s r k hs hr sr hk). assert (b := tangent_power t r (k + 2) ht hr).
  rewrite es in a. rewrite et in b. fold p in a, b.
  assert (c := exponents_cancel).
  set (u := Rpower (D / r ^ k) p) in *. set (w := Rpower (D / r ^ (k + 2)) p) in *.
  assert (hu : 0 < u) by apply exp_pos. assert (hw : 0 < w) by apply exp_pos.
  replace (m1 * (1 + s) ^ k * (m1 * (1 + t) ^ (k + 2))) with (m1 ^ 2 * ((1 + s) ^ k * (1 + t) ^ (k + 2))) by ring.
  replace ((m1 * (1 + r) ^ (k + 1)) ^ 2) with (m1 ^ 2 * ((1 + r) ^ k * (1 + r) ^ (k + 2)))
    by (rewrite !pow_add; ring).
  apply Rmult_lt_compat_l; [pos |].
  apply Rgt_lt in a. apply Rge_le in b.
  assert (h : (1 + r) ^ k * u * ((1 + r) ^ (k + 2) * w) < (1 + s) ^ k * (1 + t) ^ (k + 2)).
  { apply Rlt_le_trans with ((1 + s) ^ k * ((1 + r) ^ (k + 2) * w)).
    - apply Rmult_lt_compat_r; [pos | exact a].
    - apply Rmult_le_compat_l; [left; pos | exact b]. }
  replace ((1 + r) ^ k * (1 + r) ^ (k + 2)) with ((1 + r) ^ k * u * ((1 + r) ^ (k + 2) * w)); [exact h |].
  transitivity ((1 + r) ^ k * (1 + r) ^ (k + 2) * (u * w)); [ring | rewrite c; ring].
Qed.

Lemma doubled_cancel : Rpower (D / r ^ k) p * Rpower (1 ^ 1 / r ^ 1) p = 1.
Proof.
  assert (hD := D_pos). assert (hr : 0 < r) by (unfold r; pos).
  assert (e : r ^ (k + 1) = D) by (unfold r; apply root_power; [exact hD | lia]).
  rewrite Rpower_mult_distr; [| pos | pos].
  replace (D / r ^ k * (1 ^ 1 / r ^ 1)) with 1.
  - unfold Rpower. rewrite ln_1, Rmult_0_r. apply exp_0.
  - rewrite <- e. rewrite pow_add. field. split; pos.
Qed.

Lemma amount_doubles : amount m1 m2 (k + 1) <= 2 * amount m1 m2 k.
Proof.
  assert (hD := D_pos). assert (hr : 0 < r) by (unfold r; pos).
  rewrite !amount_ratio by lia. fold r.
  set (s := Rpower D (1 / INR k)). assert (hs : s > 0) by (unfold s; pos).
  assert (es : s ^ k = D) by (unfold s; apply root_power; [exact hD | exact hk]).
  assert (a := tangent_power s r k hs hr). assert (b := tangent_power 1 r 1 Rlt_0_1 hr).
  rewrite es in a. fold p in a, b. assert (c := doubled_cancel).
  set (u := Rpower (D / r ^ k) p) in *. set (w := Rpower (1 ^ 1 / r ^ 1) p) in *.
  assert (hu : 0 < u) by apply exp_pos. assert (hw : 0 < w) by apply exp_pos.
  rewrite !pow_1 in b. rewrite pow_add, pow_1.
  replace (2 * (m1 * (1 + s) ^ k)) with (m1 * ((1 + s) ^ k * (1 + 1))) by ring.
  apply Rmult_le_compat_l; [left; pos |].
  apply Rge_le in a. apply Rge_le in b.
  assert (h : (1 + r) ^ k * u * ((1 + r) * w) <= (1 + s) ^ k * (1 + 1)).
  { apply Rmult_le_compat; try assumption; left; pos. }
  replace ((1 + r) ^ k * (1 + r)) with ((1 + r) ^ k * u * ((1 + r) * w)); [exact h |].
  transitivity ((1 + r) ^ k * (1 + r) * (u * w)); [ring | rewrite c; ring].
Qed.

Lemma amount_doubles_strict : m1 <> m2 -> amount m1 m2 (k + 1) < 2 * amount m1 m2 k.
Proof.
  intro hd. assert (hD := D_pos). assert (hr : 0 < r) by (unfold r; pos).
  assert (hD1 : D <> 1).
  { unfold D. intro z. apply hd. apply Rmult_eq_reg_r with (/ m1); [| pos]. unfold Rdiv in z. rewrite z. field. lra. }
  rewrite !amount_ratio by lia. fold r.
  set (s := Rpower D (1 / INR k)). assert (hs : s > 0) by (unfold s; pos).
  assert (es : s ^ k = D) by (unfold s; apply root_power; [exact hD | exact hk]).
  assert (r1 : 1 <> r).
  { intro z. symmetry in z. apply root_inj in z; [| exact hD | exact hD1].
    assert (i := INR_pos (k + 1) ltac:(lia)). apply (f_equal (fun x => x * INR (k + 1))) in z. field_simplify in z; lra. }
  assert (a := tangent_power s r k hs hr).
  assert (b := tangent_power_strict 1 r 1 Rlt_0_1 hr r1 (le_n 1)).
  rewrite es in a. fold p in a, b. assert (c := doubled_cancel).
  set (u := Rpower (D / r ^ k) p) in *. set (w := Rpower (1 ^ 1 / r ^ 1) p) in *.
  assert (hu : 0 < u) by apply exp_pos. assert (hw : 0 < w) by apply exp_pos.
  rewrite !pow_1 in b. rewrite pow_add, pow_1.
  replace (2 * (m1 * (1 + s) ^ k)) with (m1 * ((1 + s) ^ k * (1 + 1))) by ring.
  apply Rmult_lt_compat_l; [exact h1 |].
  apply Rge_le in a. apply Rgt_lt in b.
  assert (h : (1 + r) ^ k * u * ((1 + r) * w) < (1 + s) ^ k * (1 + 1)).
  { apply Rle_lt_trans with ((1 + s) ^ k * ((1 + r) * w)).
    - apply Rmult_le_compat_r; [left; pos | exact a].
    - apply Rmult_lt_compat_l; [pos | exact b]. }
  replace ((1 + r) ^ k * (1 + r)) with ((1 + r) ^ k * u * ((1 + r) * w)); [exact h |].
  transitivity ((1 + r) ^ k * (1 + r) * (u * w)); [ring | rewrite c; ring].
Qed.

(** With y = D^(1/(k(k+1))): (1 + y^(k+1))^k < (1 + y^k)^(k+1). *)
Lemma amount_rises : amount m1 m2 k < amount m1 m2 (k + 1).
Proof.
  assert (hD := D_pos). rewrite !amount_ratio by lia.
  set (y := Rpower D (1 / (INR k * INR (k + 1)))).
  assert (ik := INR_pos k hk). assert (ik1 := INR_pos (k + 1) ltac:(lia)).
  assert (hy : 0 < y) by (unfold y; pos).
  assert (ea : Rpower D (1 / INR k) = y ^ (k + 1)).
  { rewrite <- Rpower_pow by exact hy. unfold y. rewrite Rpower_mult. f_equal. field. lra. }
  assert (eb : Rpower D (1 / INR (k + 1)) = y ^ k).
  { rewrite <- Rpower_pow by exact hy. unfold y. rewrite Rpower_mult. f_equal. field. lra. }
  rewrite ea, eb. apply Rmult_lt_compat_l; [exact h1 |].
  assert (hk1 : 0 < y ^ k) by pos.
  assert (le : forall a b n, 0 <= a <= b -> a ^ n <= b ^ n) by (intros; now apply pow_incr).
  replace (y ^ (k + 1)) with (y ^ k * y) by (rewrite pow_add; ring).
  replace ((1 + y ^ k) ^ (k + 1)) with ((1 + y ^ k) ^ k * (1 + y ^ k)) by (rewrite (pow_add (1 + y ^ k)); ring).
  destruct (Rle_lt_dec y 1) as [s | s].
  - apply Rle_lt_trans with ((1 + y ^ k) ^ k).
    + apply le. split; [left; pos |].
      assert (y ^ k * y <= y ^ k * 1) by (apply Rmult_le_compat_l; lra). lra.
    + rewrite <- (Rmult_1_r ((1 + y ^ k) ^ k)) at 1. apply Rmult_lt_compat_l; [pos | lra].
  - apply Rle_lt_trans with ((y * (1 + y ^ k)) ^ k).
    + apply le. split; [left; pos |]. lra.
    + rewrite Rpow_mult_distr. rewrite Rmult_comm. apply Rmult_lt_compat_l; [pos | lra].
Qed.

End Convex.

(** The square is at least 4^k m1 m2, the value at equal roots. *)
Lemma amount_least : forall k, (k >= 1)%nat -> 4 ^ k * m1 * m2 <= amount m1 m2 k ^ 2.
Proof.
  intros k hk. unfold amount. set (a := Rpower m1 (1 / INR k)). set (b := Rpower m2 (1 / INR k)).
  assert (ha : 0 < a) by apply exp_pos. assert (hb : 0 < b) by apply exp_pos.
  replace (4 ^ k * m1 * m2) with ((4 * (a * b)) ^ k).
  - rewrite <- pow_mult, Nat.mul_comm, pow_mult. apply pow_incr. split; [left; pos |].
    assert (q := pow2_ge_0 (a - b)). lra.
  - rewrite !Rpow_mult_distr. unfold a, b. rewrite !root_power by assumption. ring.
Qed.

Lemma amount_equal : m1 = m2 -> forall k, (k >= 1)%nat -> amount m1 m2 k = m1 * 2 ^ k.
Proof.
  intros e k hk. unfold amount. rewrite <- e.
  replace (Rpower m1 (1 / INR k) + Rpower m1 (1 / INR k)) with (Rpower m1 (1 / INR k) * 2) by ring.
  rewrite Rpow_mult_distr, root_power; auto.
Qed.

End Amount.
