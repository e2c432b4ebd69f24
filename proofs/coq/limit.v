(** Long chains: limits, closed forms, and the power law that no chain beats. *)

From Carom Require Import vocabulary weighted_mean chain threshold tactics collision transfer many.
From Carom Require statements.
From Coq Require Import Lra Lia.

(** ** Elastic chains *)

Lemma bernoulli : forall h, h > - 1 -> forall n, 1 + INR n * h <= (1 + h) ^ n.
Proof.
  intros h hh n. induction n as [| n ih]; [cbn; lra |]. rewrite S_INR. cbn [pow].
  apply Rle_trans with ((1 + h) * (1 + INR n * h)).
  - assert (a := pos_INR n). assert (b := pow2_ge_0 h). nra.
  - apply Rmult_le_compat_l; lra.
Qed.

Theorem lemma_bernoulli : statements.lemma_bernoulli.
Proof. start. apply Rle_ge. now apply bernoulli. Qed.

(** Roots of the two sides lie so near each other that n z^2 is at most (r - 1)^2 / n. *)
Lemma near : forall r n, r >= 1 -> (n >= 1)%nat -> let t := Rpower r (1 / INR n) in
  1 <= t /\ INR n * (t - 1) <= r - 1.
Proof.
  intros r n hr hn t. assert (ht : 0 < t) by apply exp_pos. assert (tn : t ^ n = r) by (apply root_power; [lra | exact hn]).
  assert (one : 1 <= t).
  { apply Rnot_lt_le. intro g. assert (t ^ n < 1); [| lra]. destruct n as [| n]; [lia |].
    rewrite <- (pow1 (S n)). clear tn. clearbody t. clear -ht g. induction n as [| n ih]; [lra |].
    rewrite <- (tech_pow_Rmult t), <- (tech_pow_Rmult 1). apply Rmult_gt_0_lt_compat; [pos | lra | exact g | exact ih]. }
  split; [exact one |]. assert (b := bernoulli (t - 1) ltac:(lra) n).
  replace (1 + (t - 1)) with t in b by ring. lra.
Qed.

Lemma square_bound : forall n z c, (n >= 1)%nat -> 0 <= z -> INR n * z <= c -> INR n * z ^ 2 <= c ^ 2 / INR n.
Proof.
  intros n z c hn hz h. assert (i := INR_pos n hn). apply Rmult_le_reg_r with (INR n); [exact i |].
  replace (c ^ 2 / INR n * INR n) with (c ^ 2) by (field; lra).
  replace (INR n * z ^ 2 * INR n) with ((INR n * z) ^ 2) by ring. apply pow_incr. split; [| exact h].
  apply Rmult_le_pos; lra.
Qed.

Lemma elastic_bound : forall r n, r > 0 -> (n >= 1)%nat -> let t := Rpower r (1 / INR n) in
  let eta := (4 * t / (1 + t) ^ 2) ^ n in
  eta <= 1 /\ (r >= 1 -> eta >= 1 - (r - 1) ^ 2 / INR n) /\ (r <= 1 -> eta >= 1 - (1 / r - 1) ^ 2 / INR n).
Proof.
  intros r n hr hn t eta. assert (ht : 0 < t) by apply exp_pos. assert (i := INR_pos n hn).
  set (z := (1 - t) / (1 + t)).
  assert (v : eta = (1 + - z ^ 2) ^ n) by (unfold eta, z; f_equal; field; lra).
  assert (z2 := pow2_ge_0 z).
  assert (z1 : z ^ 2 < 1).
  { assert (q : 1 - z ^ 2 = 4 * t / (1 + t) ^ 2) by (unfold z; field; lra).
    assert (0 < 4 * t / (1 + t) ^ 2) by pos. lra. }
  assert (b := bernoulli (- z ^ 2) ltac:(lra) n). rewrite <- v in b.
  split; [| split].
  - rewrite v. apply Rle_trans with (1 ^ n); [apply pow_incr; lra | rewrite pow1; lra].
  - intro h. destruct (near r n h hn) as [t1 tn]. fold t in t1, tn.
    assert (s := square_bound n (- z) (r - 1) hn).
    assert (zt : - z <= t - 1).
    { unfold z. apply Rmult_le_reg_r with (1 + t); [lra |].
      replace (- ((1 - t) / (1 + t)) * (1 + t)) with ((t - 1) * 1) by (field; lra). apply Rmult_le_compat_l; lra. }
    assert (zp : 0 <= - z).
    { unfold z. replace (- ((1 - t) / (1 + t))) with ((t - 1) * / (1 + t)) by (field; lra).
      apply Rmult_le_pos; [lra | left; pos]. }
    specialize (s zp). assert (m : INR n * - z <= INR n * (t - 1)) by (apply Rmult_le_compat_l; lra).
    specialize (s ltac:(lra)). lra.
  - intro h. assert (hr' : 1 / r >= 1).
    { apply Rle_ge. apply Rmult_le_reg_r with r; [lra |]. replace (1 / r * r) with 1 by (field; lra). lra. }
    destruct (near (1 / r) n hr' hn) as [t1 tn].
    assert (ti : Rpower (1 / r) (1 / INR n) = 1 / t).
    { replace (1 / r) with (/ r) by (field; lra). unfold t, Rpower. rewrite ln_Rinv by lra.
      replace (1 / INR n * - ln r) with (- (1 / INR n * ln r)) by ring. rewrite exp_Ropp. unfold Rdiv. ring. }
    rewrite ti in t1, tn.
    assert (s := square_bound n z (1 / r - 1) hn).
    assert (zt : z <= 1 / t - 1).
    { unfold z. replace (1 / t - 1) with ((1 - t) / t) by (field; lra).
      assert (t <= 1). { apply Rmult_le_reg_r with (1 / t); [pos |]. replace (t * (1 / t)) with 1 by (field; lra). lra. }
      apply quotient_le; [lra | lra |]. apply Rmult_le_compat_l; lra. }
    assert (t' : t <= 1). { apply Rmult_le_reg_r with (1 / t); [pos |]. replace (t * (1 / t)) with 1 by (field; lra). lra. }
    assert (zp : 0 <= z) by (unfold z; apply Rmult_le_pos; [lra | left; pos]).
    specialize (s zp). assert (m : INR n * z <= INR n * (1 / t - 1)) by (apply Rmult_le_compat_l; lra).
    specialize (s ltac:(lra)). lra.
Qed.

Theorem lemma_elastic_bound : statements.lemma_elastic_bound.
Proof. start. now apply elastic_bound. Qed.

Theorem lemma_elastic_bound_defined : statements.lemma_elastic_bound_defined.
Proof. values. Qed.

(** The elastic share with n collisions. *)
Lemma elastic_share : forall r m n, r > 0 -> m > 0 -> (n >= 1)%nat ->
  4 ^ n * (r * m) * m / amount (r * m) m n ^ 2 = (4 * Rpower r (1 / INR n) / (1 + Rpower r (1 / INR n)) ^ 2) ^ n.
Proof.
  intros r m n hr hm hn. set (t := Rpower r (1 / INR n)). assert (ht : 0 < t) by apply exp_pos.
  assert (tn : t ^ n = r) by (apply root_power; assumption).
  assert (a : amount (r * m) m n = m * (1 + t) ^ n).
  { unfold amount. rewrite <- Rpower_mult_distr by assumption. fold t.
    replace (t * Rpower m (1 / INR n) + Rpower m (1 / INR n)) with (Rpower m (1 / INR n) * (1 + t)) by ring.
    rewrite Rpow_mult_distr, root_power by assumption. reflexivity. }
  rewrite a. unfold Rdiv at 2. rewrite !Rpow_mult_distr, pow_inv, tn. rewrite <- (pow_mult (1 + t)), Nat.mul_comm, pow_mult.
  field. split; pos.
Qed.

(** ** Limits by squeezing *)

Lemma tends_to_one : forall c, is_lim_seq (fun n => 1 - c / INR n) 1.
Proof.
  intro c. replace (Finite 1) with (Finite (1 - c * 0)) by (f_equal; ring).
  apply is_lim_seq_minus'; [apply is_lim_seq_const |].
  apply is_lim_seq_ext with (fun n => c * / INR n); [reflexivity |].
  apply (is_lim_seq_scal_l (fun n => / INR n) c 0).
  replace (Finite 0) with (Rbar_inv p_infty) by reflexivity. apply is_lim_seq_inv; [apply is_lim_seq_INR | discriminate].
Qed.

Lemma squeeze : forall (u lo hi : nat -> R) l, (forall n, (n >= 1)%nat -> lo n <= u n <= hi n) ->
  is_lim_seq lo l -> is_lim_seq hi l -> is_lim_seq u l.
Proof.
  intros u lo hi l h a b. apply is_lim_seq_le_le_loc with lo hi; [| exact a | exact b].
  exists 1%nat. intros n hn. apply h. exact hn.
Qed.

(** One constant for both cases of the bound. *)
Lemma elastic_lower : forall r n, r > 0 -> (n >= 1)%nat -> let t := Rpower r (1 / INR n) in
  1 - ((r - 1) ^ 2 + (1 / r - 1) ^ 2) / INR n <= (4 * t / (1 + t) ^ 2) ^ n <= 1.
Proof.
  intros r n hr hn t. destruct (elastic_bound r n hr hn) as (up & big & small). fold t in up, big, small.
  assert (i := INR_pos n hn). split; [| exact up].
  assert (a : 0 <= (r - 1) ^ 2 / INR n) by (apply Rmult_le_pos; [apply pow2_ge_0 | left; pos]).
  assert (b : 0 <= (1 / r - 1) ^ 2 / INR n) by (apply Rmult_le_pos; [apply pow2_ge_0 | left; pos]).
  replace (((r - 1) ^ 2 + (1 / r - 1) ^ 2) / INR n) with ((r - 1) ^ 2 / INR n + (1 / r - 1) ^ 2 / INR n) by (field; lra).
  destruct (Rle_lt_dec 1 r) as [h | h]; [specialize (big ltac:(lra)) | specialize (small ltac:(lra))]; lra.
Qed.

Theorem b_limit : statements.b_limit.
Proof.
  start. apply squeeze with (fun n => 1 - ((r - 1) ^ 2 + (1 / r - 1) ^ 2) / INR n) (fun _ => 1).
  - intros k hk. rewrite double_power. fold (amount (r * m2) m2 k). rewrite elastic_share by assumption.
    now apply elastic_lower.
  - apply tends_to_one.
  - apply is_lim_seq_const.
Qed.

Theorem b_limit_defined : statements.b_limit_defined.
Proof. values. Qed.

(** Twice the elastic share lies below the quotient of neighbouring amounts. *)
Lemma share_below : forall r m2 n, r > 0 -> m2 > 0 -> (n >= 1)%nat ->
  2 * (4 * Rpower r (1 / INR n) / (1 + Rpower r (1 / INR n)) ^ 2) ^ n
    <= amount (r * m2) m2 (n + 1) / amount (r * m2) m2 n.
Proof.
  intros r m2 k H0 H hk. assert (h1 : r * m2 > 0) by pos.
  assert (pa := amount_pos (r * m2) m2 k). assert (pb := amount_pos (r * m2) m2 (k + 1)).
  assert (low := amount_least (r * m2) m2 h1 H (k + 1) ltac:(lia)).
  assert (share := elastic_share r m2 k H0 H hk). destruct (elastic_lower r k H0 hk) as [_ hi].
  rewrite <- share in hi |- *. clear share. rewrite pow_add, pow_1 in low.
  set (A := amount (r * m2) m2 k) in *. set (B := amount (r * m2) m2 (k + 1)) in *.
  set (eta := 4 ^ k * (r * m2) * m2 / A ^ 2) in *.
  assert (he : 0 < eta) by (unfold eta; pos). assert (q : 0 < B / A) by pos.
  apply (square_le_iff (2 * eta) (B / A) ltac:(lra) ltac:(lra)).
  apply Rle_trans with (4 * eta).
  - replace ((2 * eta) ^ 2) with (4 * eta * eta) by ring. rewrite <- (Rmult_1_r (4 * eta)) at 2.
    apply Rmult_le_compat_l; lra.
  - unfold eta. replace ((B / A) ^ 2) with (B ^ 2 / A ^ 2) by (field; lra).
    replace (4 * (4 ^ k * (r * m2) * m2 / A ^ 2)) with (4 ^ k * 4 * (r * m2) * m2 / A ^ 2) by (field; lra).
    apply quotient_le; [pos | pos |]. apply Rmult_le_compat_r; [left; pos | exact low].
Qed.

Theorem b_grow_limit : statements.b_grow_limit.
Proof.
  start. set (c := (r - 1) ^ 2 + (1 / r - 1) ^ 2).
  apply squeeze with (fun n => 1 - 2 * c / INR n) (fun _ => 1).
  - intros k hk. fold (amount (r * m2) m2 k). fold (amount (r * m2) m2 (k + 1)).
    assert (pa := amount_pos (r * m2) m2 k).
    assert (up := amount_doubles (r * m2) m2 ltac:(pos) H k hk).
    assert (low := share_below r m2 k H0 H hk). destruct (elastic_lower r k H0 hk) as [lo _]. fold c in lo.
    set (A := amount (r * m2) m2 k) in *. set (B := amount (r * m2) m2 (k + 1)) in *.
    assert (top : B / A <= 2).
    { replace 2 with (2 * A / A) by (field; lra). apply quotient_le; [lra | lra |]. apply Rmult_le_compat_r; lra. }
    assert (i := INR_pos k hk). replace (2 * c / INR k) with (2 * (c / INR k)) by (field; lra). lra.
  - apply tends_to_one.
  - apply is_lim_seq_const.
Qed.

Theorem b_grow_limit_defined : statements.b_grow_limit_defined.
Proof. values. Qed.

Theorem b_limit_inelastic : statements.b_limit_inelastic.
Proof.
  start. set (q := ((1 + e) / 2) ^ 2).
  assert (hq : 0 <= q < 1) by (unfold q; split; [apply pow2_ge_0 | nra]).
  apply squeeze with (fun _ => 0) (fun n => q ^ n).
  - intros k hk. rewrite !double_power. fold (amount m1 m2 k).
    assert (pa := amount_pos m1 m2 k). assert (low := amount_least m1 m2 H H0 k hk). split.
    + left. pos.
    + replace (q ^ k) with ((((1 + e) / 2) ^ k) ^ 2) by (unfold q; rewrite <- !pow_mult; f_equal; lia).
      unfold Rdiv at 2. rewrite Rpow_mult_distr, pow_inv. set (E := (1 + e) ^ k). assert (hE : 0 < E) by (unfold E; pos).
      replace ((E * / 2 ^ k) ^ 2) with (E ^ 2 / (2 ^ k) ^ 2) by (field; pos).
      apply quotient_le; [pos | pos |]. rewrite !Rmult_assoc. apply Rmult_le_compat_l; [left; pos |].
      replace ((2 ^ k) ^ 2) with (4 ^ k); [lra |].
      replace 4 with (2 ^ 2) by ring. rewrite <- !pow_mult. f_equal. lia.
  - apply is_lim_seq_const.
  - apply is_lim_seq_geom. rewrite Rabs_pos_eq; lra.
Qed.

Theorem b_limit_inelastic_defined : statements.b_limit_inelastic_defined.
Proof. values. Qed.

(** ** How many bodies help *)

Theorem b_best_elastic : statements.b_best_elastic.
Proof.
  start. fold (amount m1 m2 n). fold (amount m1 m2 (n + 1)). assert (a := amount_pos m1 m2 n). split; intro h.
  - assert (d := amount_doubles_strict m1 m2 H H0 n H1 h).
    assert (q : amount m1 m2 (n + 1) / amount m1 m2 n < 2 / 1) by (apply quotient_lt_iff; lra). lra.
  - rewrite (amount_equal m1 m2 H h (n + 1)), (amount_equal m1 m2 H h n) by lia. rewrite pow_add, pow_1.
    assert (0 < 2 ^ n) by pos. field. lra.
Qed.

Theorem b_best_elastic_defined : statements.b_best_elastic_defined.
Proof. values. Qed.

Theorem b_best_finite : statements.b_best_finite.
Proof.
  start. fold (amount (r * m2) m2 n). fold (amount (r * m2) m2 (n + 1)).
  assert (hr : r > 0) by lra. assert (low := share_below r m2 n hr H H2).
  destruct (elastic_bound r n hr H2) as (_ & big & _). specialize (big H0).
  assert (i := INR_pos n H2).
  assert (room : (r - 1) ^ 2 / INR n < (1 - e) / 2).
  { apply quotient_lt_iff; [exact i | lra |]. lra. }
  lra.
Qed.

Theorem b_best_finite_defined : statements.b_best_finite_defined.
Proof. start. assert (0 < r) by lra. repeat split; pos. Qed.
