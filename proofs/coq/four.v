(** Two inserted bodies, and the order of the first two thresholds. *)

From Carom Require Import vocabulary weighted_mean chain tactics collision transfer.
From Carom Require statements.
From Coq Require Import Lra Lia.

(** ** The best two masses: the chain's bound for three links *)

Section Three.
Variables m1 m2 u w : R.
Hypotheses (h1 : m1 > 0) (h2 : m2 > 0) (hu : u > 0) (hw : w > 0).

Let mu (k : nat) : R := match k with 0%nat => m1 | 1%nat => u | 2%nat => w | _ => m2 end.

Lemma mu_pos : forall k, mu k > 0.
Proof. intros [| [| [| k]]]; assumption. Qed.

Let r := cbrt m2 / cbrt m1.

Lemma ratio_is : Rpower (mu 3 / mu 0) (1 / INR 3) = r.
Proof. cbn [mu]. rewrite root_quotient by assumption. unfold r, cbrt. now replace (INR 3) with 3 by (cbn; ring). Qed.

Lemma links_is : linked mu 2 = (m1 + u) * (u + w) * (w + m2).
Proof. unfold linked, product_over. cbn. ring. Qed.

Lemma bound_is : product_over 1 2 mu * (Rpower (mu 0%nat) (1 / INR 3) + Rpower (mu 3%nat) (1 / INR 3)) ^ 3
  = u * w * (cbrt m1 + cbrt m2) ^ 3.
Proof.
  unfold product_over, cbrt. cbn [mu product_terms Nat.add Nat.sub].
  replace (INR 3) with 3 by (cbn; ring). ring.
Qed.

Lemma three_links : u * w * (cbrt m1 + cbrt m2) ^ 3 <= (m1 + u) * (u + w) * (w + m2).
Proof. rewrite <- bound_is, <- links_is. apply Rge_le. exact (chain_bound mu 2 mu_pos). Qed.

Lemma three_links_equal : (m1 + u) * (u + w) * (w + m2) = u * w * (cbrt m1 + cbrt m2) ^ 3 <->
  u = m1 * r /\ w = u * r /\ m2 = w * r.
Proof.
  rewrite <- bound_is, <- links_is.
  assert (strict := chain_bound_strict mu 2 mu_pos). cbn [Nat.add] in strict. rewrite ratio_is in strict.
  assert (attained := chain_attained mu 2 mu_pos). cbn [Nat.add] in attained. rewrite ratio_is in attained. split.
  - intro h. repeat split.
    + destruct (Req_dec u (m1 * r)) as [e | ne]; [exact e |]. specialize (strict 0%nat ltac:(lia) ne). lra.
    + destruct (Req_dec w (u * r)) as [e | ne]; [exact e |]. specialize (strict 1%nat ltac:(lia) ne). lra.
    + destruct (Req_dec m2 (w * r)) as [e | ne]; [exact e |]. specialize (strict 2%nat ltac:(lia) ne). lra.
  - intros (a & b & c). apply attained. intros [| [| [| i]]] hi; cbn; try assumption. lia.
Qed.

End Three.

(** A positive number by its cube root. *)
Lemma cube_root : forall m, m > 0 -> 0 < cbrt m /\ m = cbrt m ^ 3.
Proof.
  intros m hm. assert (ha : 0 < cbrt m) by apply exp_pos. split; [exact ha |].
  unfold cbrt in *. rewrite <- Rpower_pow by exact ha. rewrite Rpower_mult.
  replace (1 / 3 * INR 3) with 1 by (cbn; field). symmetry. now apply Rpower_1.
Qed.

Lemma cbrt_cube : forall a, 0 < a -> cbrt (a ^ 3) = a.
Proof.
  intros a ha. unfold cbrt. rewrite <- Rpower_pow by exact ha. rewrite Rpower_mult.
  replace (INR 3 * (1 / 3)) with 1 by (cbn; field). now apply Rpower_1.
Qed.

Theorem eq17 : statements.eq17.
Proof.
  start. set (k := (1 + e1) ^ 2 * (1 + e2) ^ 2 * (1 + e3) ^ 2 * m1 * m2).
  assert (hk : 0 < k) by (unfold k; pos). clearbody k.
  assert (least := three_links m1 m2 mu1 mu2 H H0 H1 H2).
  assert (equal := three_links_equal m1 m2 mu1 mu2 H H0 H1 H2).
  destruct (cube_root m1 H) as [ha h1]. destruct (cube_root m2 H0) as [hb h2].
  assert (r1 : cbrt (m1 ^ 2 * m2) = cbrt m1 ^ 2 * cbrt m2).
  { rewrite h1 at 1. rewrite h2 at 1. replace ((cbrt m1 ^ 3) ^ 2 * cbrt m2 ^ 3) with ((cbrt m1 ^ 2 * cbrt m2) ^ 3) by ring.
    apply cbrt_cube. pos. }
  assert (r2 : cbrt (m1 * m2 ^ 2) = cbrt m1 * cbrt m2 ^ 2).
  { rewrite h1 at 1. rewrite h2 at 1. replace (cbrt m1 ^ 3 * (cbrt m2 ^ 3) ^ 2) with ((cbrt m1 * cbrt m2 ^ 2) ^ 3) by ring.
    apply cbrt_cube. pos. }
  rewrite r1, r2. clear r1 r2. set (a := cbrt m1) in *. set (b := cbrt m2) in *. clearbody a b.
  destruct (best_share k (mu1 * mu2) ((a + b) ^ 3) ((m1 + mu1) * (mu1 + mu2) * (mu2 + m2)) hk ltac:(pos) ltac:(pos) least)
    as [le eq].
  replace (k * mu1 ^ 2 * mu2 ^ 2 / ((m1 + mu1) ^ 2 * (mu1 + mu2) ^ 2 * (mu2 + m2) ^ 2))
    with (k * (mu1 * mu2) ^ 2 / ((m1 + mu1) * (mu1 + mu2) * (mu2 + m2)) ^ 2) by (field; lra).
  replace (k / (a + b) ^ 6) with (k / ((a + b) ^ 3) ^ 2) by (field; lra).
  split; [| split; [exact le |]].
  - rewrite h1, h2. field. repeat split; apply Rgt_not_eq; pos.
  - rewrite eq, equal. split.
    + intros (p & q & _). rewrite q, p, h1. split; field; lra.
    + intros [-> ->]. rewrite h1, h2. repeat split; field; lra.
Qed.

Theorem eq17_defined : statements.eq17_defined.
Proof. values. Qed.

Theorem eq18 : statements.eq18.
Proof.
  start. assert (0 < sqrt m1) by pos. assert (0 < sqrt m2) by pos. assert (0 < cbrt m1) by pos. assert (0 < cbrt m2) by pos.
  replace ((1 + e) ^ 6 * m1 * m2 / (cbrt m1 + cbrt m2) ^ 6)
    with ((1 + e) ^ 4 * m1 * m2 * (1 + e) ^ 2 / ((cbrt m1 + cbrt m2) ^ 3) ^ 2) by (field; lra).
  replace ((sqrt m1 + sqrt m2) ^ 4) with (((sqrt m1 + sqrt m2) ^ 2) ^ 2) by ring.
  rewrite helps by pos. split; intro; lra.
Qed.

Theorem eq18_defined : statements.eq18_defined.
Proof. values. Qed.

(** Masses 64 and 1: their roots are 8, 4 and 1. *)
Lemma roots_64 : sqrt 64 = 8 /\ cbrt 64 = 4 /\ sqrt 1 = 1 /\ cbrt 1 = 1.
Proof.
  repeat split.
  - replace 64 with (8 ^ 2) by ring. apply sqrt_pow2. lra.
  - replace 64 with (4 ^ 3) by ring. apply cbrt_cube. lra.
  - apply sqrt_1.
  - replace 1 with (1 ^ 3) at 1 by ring. apply cbrt_cube. lra.
Qed.

Theorem eq18_extracted : statements.eq18_extracted.
Proof.
  start. intro h. specialize (h 64 1 ltac:(lra) ltac:(lra) (3 / 10) ltac:(lra)). cbv zeta in h.
  destruct roots_64 as (r1 & r2 & r3 & r4). rewrite r1, r2, r3, r4 in h. destruct h as [h _].
  assert (z : (4 + 1) ^ 3 / (8 + 1) ^ 2 - 1 > 3 / 10) by lra.
  enough (sqrt ((1 + 3 / 10) ^ 4 * 64 * 1 / (8 + 1) ^ 4 / ((1 + 3 / 10) ^ 2 * 64 * 1 / (64 + 1) ^ 2)) >= 1) by (specialize (h H); lra).
  apply Rle_ge. rewrite <- sqrt_1 at 1. apply sqrt_le_1_alt.
  replace ((1 + 3 / 10) ^ 4 * 64 * 1 / (8 + 1) ^ 4 / ((1 + 3 / 10) ^ 2 * 64 * 1 / (64 + 1) ^ 2)) with (7140250 / 6561000) by field.
  lra.
Qed.

Theorem p_two_converse : statements.p_two_converse.
Proof.
  start. intro h. specialize (h 64 1 ltac:(lra) ltac:(lra) (9 / 20) ltac:(lra)). cbv zeta in h.
  destruct roots_64 as (r1 & r2 & r3 & r4). rewrite r1, r2, r3, r4 in h.
  enough (c : 9 / 20 >= (4 + 1) ^ 3 / (8 + 1) ^ 2 - 1) by lra. apply h. apply Rle_ge, quotient_le; lra.
Qed.

Theorem u12 : statements.u12.
Proof.
  start. assert (0 < sqrt m1) by pos. assert (0 < sqrt m2) by pos. assert (0 < cbrt m1) by pos. assert (0 < cbrt m2) by pos.
  split; [field; lra |].
  replace ((1 + e) ^ 6 * m1 * m2 / (cbrt m1 + cbrt m2) ^ 6)
    with ((1 + e) ^ 4 * m1 * m2 * (1 + e) ^ 2 / ((cbrt m1 + cbrt m2) ^ 3) ^ 2) by (field; lra).
  replace ((1 + e) ^ 4 * m1 * m2 / (sqrt m1 + sqrt m2) ^ 4)
    with ((1 + e) ^ 4 * m1 * m2 * 1 ^ 2 / ((sqrt m1 + sqrt m2) ^ 2) ^ 2) by (field; lra).
  rewrite shares_compared by pos. now rewrite Rmult_1_l.
Qed.

Theorem u12_defined : statements.u12_defined.
Proof. values. Qed.

(** ** The second threshold lies above the first *)

Lemma sixth_powers : forall a b, 0 < a -> 0 < b ->
  (a ^ 3 + b ^ 3) ^ 4 <= (a ^ 2 + b ^ 2) ^ 3 * (a ^ 6 + b ^ 6) /\
  ((a ^ 2 + b ^ 2) ^ 3 * (a ^ 6 + b ^ 6) = (a ^ 3 + b ^ 3) ^ 4 <-> a = b).
Proof.
  intros a b ha hb.
  set (c := a ^ 2 * b ^ 2 * (3 * a ^ 6 + 2 * (a ^ 5 * b) + 4 * (a ^ 4 * b ^ 2) + 6 * (a ^ 3 * b ^ 3)
    + 4 * (a ^ 2 * b ^ 4) + 2 * (a * b ^ 5) + 3 * b ^ 6)).
  assert (hc : 0 < c) by (unfold c; pos).
  assert (d : (a ^ 2 + b ^ 2) ^ 3 * (a ^ 6 + b ^ 6) - (a ^ 3 + b ^ 3) ^ 4 = c * (a - b) ^ 2) by (unfold c; ring).
  assert (s := pow2_ge_0 (a - b)). split.
  - assert (0 <= c * (a - b) ^ 2) by (apply Rmult_le_pos; lra). lra.
  - split; intro h.
    + rewrite h, Rminus_diag_eq in d by reflexivity. symmetry in d. apply product_zero in d; [nra | lra].
    + rewrite h. ring.
Qed.

Lemma thresholds_rise : forall m1 m2, m1 > 0 -> m2 > 0 ->
  (sqrt m1 + sqrt m2) ^ 2 / (m1 + m2) <= (cbrt m1 + cbrt m2) ^ 3 / (sqrt m1 + sqrt m2) ^ 2 /\
  ((cbrt m1 + cbrt m2) ^ 3 / (sqrt m1 + sqrt m2) ^ 2 = (sqrt m1 + sqrt m2) ^ 2 / (m1 + m2) <-> m1 = m2).
Proof.
  intros m1 m2 h1 h2. destruct (sixth_root m1 h1) as (a & ha & e1 & -> & ->).
  destruct (sixth_root m2 h2) as (b & hb & e2 & -> & ->). destruct (sixth_powers a b ha hb) as [le eq].
  assert (0 < a ^ 3) by pos. assert (0 < b ^ 3) by pos. rewrite e1, e2 in *. split.
  - apply quotient_le; [pos | pos |]. lra.
  - rewrite quotient_eq_iff by pos. split; intro h.
    + replace a with b; [reflexivity |]. symmetry. apply eq. lra.
    + assert (ab : a = b).
      { assert (z : (a ^ 5 + a ^ 4 * b + a ^ 3 * b ^ 2 + a ^ 2 * b ^ 3 + a * b ^ 4 + b ^ 5) * (a - b) = 0) by lra.
        apply product_zero in z; [lra | pos]. }
      rewrite ab. ring.
Qed.

Theorem p_grow : statements.p_grow.
Proof. start. destruct (thresholds_rise m1 m2 H H0) as [le eq]. split; [lra |]. rewrite <- eq. split; intro; lra. Qed.

Theorem p_grow_defined : statements.p_grow_defined.
Proof. values. Qed.

Lemma sqrt_ratio : forall a b, a > 0 -> b > 0 -> sqrt (a / b) = sqrt a / sqrt b.
Proof. intros. apply sqrt_div; lra. Qed.

Lemma cbrt_ratio : forall a b, a > 0 -> b > 0 -> cbrt (a / b) = cbrt a / cbrt b.
Proof. intros. unfold cbrt. now apply root_quotient. Qed.

Theorem u13 : statements.u13.
Proof.
  start. destruct (thresholds_rise m1 m2 H H0) as [le eq].
  rewrite sqrt_ratio, cbrt_ratio by assumption.
  set (first := (sqrt m1 + sqrt m2) ^ 2 / (m1 + m2)) in *.
  set (second := (cbrt m1 + cbrt m2) ^ 3 / (sqrt m1 + sqrt m2) ^ 2) in *.
  assert (hf : 0 < first) by (unfold first; pos).
  assert (q : second / first = (cbrt m1 + cbrt m2) ^ 3 * (m1 + m2) / (sqrt m1 + sqrt m2) ^ 4).
  { assert (0 < sqrt m1) by pos. assert (0 < sqrt m2) by pos. unfold first, second. field. lra. }
  split; [exact q |]. split; [| split].
  - rewrite q. clear - H H0. destruct (sixth_root m1 H) as (a & ha & e1 & -> & ->).
    destruct (sixth_root m2 H0) as (b & hb & e2 & -> & ->). rewrite e1, e2.
    field. repeat split; apply Rgt_not_eq; pos.
  - replace 1 with (first / first) by (field; lra). apply Rle_ge, quotient_le; [exact hf | exact hf |].
    apply Rmult_le_compat_r; lra.
  - rewrite quotient_one by exact hf. exact eq.
Qed.

Theorem u13_defined : statements.u13_defined.
Proof. values. Qed.

Theorem p_two : statements.p_two.
Proof.
  start. destruct (thresholds_rise m1 m2 H H0) as [rise _].
  assert (0 < sqrt m1) by pos. assert (0 < sqrt m2) by pos. assert (0 < cbrt m1) by pos. assert (0 < cbrt m2) by pos.
  assert (four : (1 + e) ^ 6 * m1 * m2 / (cbrt m1 + cbrt m2) ^ 6 >= (1 + e) ^ 4 * m1 * m2 / (sqrt m1 + sqrt m2) ^ 4).
  { apply (proj2 (eq18 m1 m2 H H0 e H1)). exact H2. }
  split; [exact four |]. apply Rge_trans with ((1 + e) ^ 4 * m1 * m2 / (sqrt m1 + sqrt m2) ^ 4); [exact four |].
  apply (proj2 (proj1 (eq15 m1 m2 H H0 e H1))). lra.
Qed.

Theorem p_two_defined : statements.p_two_defined.
Proof. values. Qed.
