(** Any number of inserted bodies: velocities, masses, shares and thresholds. *)

From Carom Require Import vocabulary weighted_mean chain threshold tactics collision transfer.
From Carom Require statements.
From Coq Require Import Lra Lia.

Lemma double_power : forall x k, x ^ (2 * k) = (x ^ k) ^ 2.
Proof. intros. rewrite Nat.mul_comm. apply pow_mult. Qed.

(** ** Velocities *)

Lemma by_steps : forall (u : nat -> R) g v, u 0%nat = v -> (forall k, u (k + 1)%nat = g * u k) ->
  forall n, u n = g ^ n * v.
Proof.
  intros u g v h0 hs n. induction n as [| n ih]; [rewrite h0; cbn; ring |].
  replace (S n) with (n + 1)%nat by lia. rewrite hs, ih, pow_add. ring.
Qed.

Theorem eq22 : statements.eq22.
Proof.
  start. rewrite (by_steps u (x * (1 + e) / (x + 1)) v1 H2 H3 i).
  unfold Rdiv at 2. rewrite Rpow_mult_distr, pow_inv, pow_add. field. assert (0 < (x + 1) ^ i) by pos. lra.
Qed.

Theorem eq22_defined : statements.eq22_defined.
Proof. values. Qed.

Theorem eq23 : statements.eq23.
Proof. start. field. lra. Qed.

Theorem eq23_defined : statements.eq23_defined.
Proof. values. Qed.

Theorem eq24 : statements.eq24.
Proof. start. exact (by_steps u (x * (1 + e) / (x + 1)) v1 H2 H3 (n + 1)). Qed.

Theorem eq24_defined : statements.eq24_defined.
Proof. values. Qed.

Theorem b_superball : statements.b_superball.
Proof. start. rewrite (by_steps u (x * (1 + e) / (x + 1)) ((1 + e_f) * v) H3 H4 k). ring. Qed.

Theorem b_superball_defined : statements.b_superball_defined.
Proof. values. Qed.

Theorem b_budget : statements.b_budget.
Proof.
  start. assert (hs : forall k, mu k + mu (k + 1)%nat <> 0) by (intro; pos; apply H).
  induction n as [| n [ih1 ih2]].
  - rewrite !sum_over_one. cbn [Nat.add]. specialize (H2 0%nat). cbn [Nat.add] in H2. rewrite H2, <- H1.
    specialize (hs 0%nat). cbn [Nat.add] in hs. split; field; exact hs.
  - rewrite !sum_over_last by lia. replace (S n) with (n + 1)%nat by lia. rewrite (H2 (n + 1)%nat).
    specialize (hs (n + 1)%nat). split.
    + rewrite <- ih1. field. exact hs.
    + rewrite ih2. field. exact hs.
Qed.

Theorem b_budget_defined : statements.b_budget_defined.
Proof. start. repeat split; intros; pos; apply H. Qed.

Theorem p_final : statements.p_final.
Proof. start. intro h. specialize (h 1 1 ltac:(lra) ltac:(lra) (1 / 2) ltac:(lra) 0%nat). cbv zeta in h. cbn in h. lra. Qed.

Theorem p_final_repaired : statements.p_final_repaired.
Proof.
  start. rewrite pow_add, pow_1. set (g := x * (1 + e) / (x + 1)).
  assert (hx : 0 < x + 1) by lra. assert (hg : 0 < g) by (unfold g; pos).
  assert (hu : 0 < g ^ i * v1) by pos. set (u := g ^ i) in *. split.
  - assert (d : (x - e) / (x + 1) * (u * g * v1) - (x - e) / (x + 1) * (u * v1)
      = (u * v1) / (x + 1) ^ 2 * ((x - e) * (x * e - 1))) by (unfold g; field; lra).
    assert (c : 0 < (u * v1) / (x + 1) ^ 2) by pos. set (c' := (u * v1) / (x + 1) ^ 2) in *. clearbody c'. split; intro h.
    + assert (p : 0 <= c' * ((x - e) * (x * e - 1))) by lra.
      assert (q : 0 <= (x - e) * (x * e - 1)) by (apply Rmult_le_reg_l with c'; lra).
      destruct (Rle_lt_dec x e) as [l | l]; [now left | right]. apply Rle_ge.
      apply Rmult_le_reg_l with (x - e); lra.
    + assert (q : 0 <= (x - e) * (x * e - 1)).
      { destruct h as [h | h].
        - assert (x * e <= 1) by nra. nra.
        - assert (e <= x) by nra. apply Rmult_le_pos; lra. }
      assert (0 <= c' * ((x - e) * (x * e - 1))) by (apply Rmult_le_pos; lra). lra.
  - replace (u * g * v1) with ((u * v1) * g) by ring. rewrite Rmult_comm. apply Rmult_le_compat_l; [lra |].
    unfold g. apply quotient_le; [lra | lra |]. apply Rmult_le_compat_r; nra.
Qed.

Theorem p_final_repaired_defined : statements.p_final_repaired_defined.
Proof. values. Qed.

(** ** Masses *)

Lemma exponents_sum : forall a x y z, a > 0 -> x + y = 2 * z ->
  Rpower a x * Rpower a y = Rpower a z ^ 2.
Proof.
  intros a x y z ha h. rewrite <- Rpower_plus, h. cbn. rewrite Rmult_1_r, <- Rpower_plus. f_equal. ring.
Qed.

Theorem eq20 : statements.eq20.
Proof.
  start. assert (hN := INR_pos (n + 1) ltac:(lia)). rewrite !plus_INR in *. cbn [INR] in *. set (N := INR n + 1) in *.
  split; [| split].
  - set (c := Rpower m1 ((N - INR i) / N) * Rpower m2 (INR i / N)).
    assert (hc : 0 < c) by (unfold c; pos).
    rewrite <- (sqrt_pow2 c) by lra. f_equal. unfold c. rewrite Rpow_mult_distr.
    rewrite <- (exponents_sum m1 ((N - (INR i - 1)) / N) ((N - (INR i + 1)) / N)) by (try assumption; field; lra).
    rewrite <- (exponents_sum m2 ((INR i - 1) / N) ((INR i + 1) / N)) by (try assumption; field; lra). ring.
  - replace ((N - 0) / N) with 1 by (field; lra). replace (0 / N) with 0 by (field; lra).
    rewrite Rpower_1, Rpower_O by assumption. ring.
  - replace ((N - N) / N) with 0 by (field; lra). replace (N / N) with 1 by (field; lra).
    rewrite Rpower_1, Rpower_O by assumption. ring.
Qed.

Theorem eq20_defined : statements.eq20_defined.
Proof. values. Qed.

Theorem eq20_converse : statements.eq20_converse.
Proof.
  start. assert (every : forall n, mu (n + 1)%nat * mu 0%nat = mu n * mu 1%nat).
  { clear n. induction n as [| n ih]; [cbn; ring |]. replace (S n) with (n + 1)%nat by lia.
    replace (n + 1 + 1)%nat with (n + 2)%nat by lia. apply Rmult_eq_reg_l with (mu n); [| pos; apply H].
    transitivity (mu (n + 1)%nat * (mu (n + 1)%nat * mu 0%nat)); [| rewrite ih; ring].
    rewrite <- Rmult_assoc, <- (H0 n). ring. }
  apply quotient_eq_iff; [apply H | apply H |]. rewrite every. ring.
Qed.

Theorem eq20_converse_defined : statements.eq20_converse_defined.
Proof. start. repeat split; pos; apply H. Qed.

Theorem eq21 : statements.eq21.
Proof.
  start. assert (hN := INR_pos (n + 1) ltac:(lia)). rewrite !plus_INR in *. cbn [INR] in *. set (N := INR n + 1) in *.
  split; [| split].
  - rewrite root_quotient by assumption.
    replace ((N - INR i) / N) with ((N - (INR i + 1)) / N + 1 / N) by (field; lra).
    replace ((INR i + 1) / N) with (INR i / N + 1 / N) by (field; lra).
    rewrite !Rpower_plus. field. repeat split; pos.
  - replace ((N - 0) / N) with 1 by (field; lra). replace (0 / N) with 0 by (field; lra).
    rewrite Rpower_1, Rpower_O by assumption. ring.
  - replace ((N - N) / N) with 0 by (field; lra). replace (N / N) with 1 by (field; lra).
    rewrite Rpower_1, Rpower_O by assumption. ring.
Qed.

Theorem eq21_defined : statements.eq21_defined.
Proof. values. Qed.

(** ** Shares *)

(** With x = (m1/m2)^(1/N): x/(x + 1) is the part of m1^(1/N) in the sum of the roots. *)
Lemma ratio_part : forall m1 m2 y, m1 > 0 -> m2 > 0 ->
  Rpower (m1 / m2) y / (Rpower (m1 / m2) y + 1) = Rpower m1 y / (Rpower m1 y + Rpower m2 y).
Proof.
  intros m1 m2 y h1 h2. rewrite root_quotient by assumption.
  assert (0 < Rpower m1 y) by pos. assert (0 < Rpower m2 y) by pos. field. lra.
Qed.

Lemma last_velocity : forall m1 m2 e n, m1 > 0 -> m2 > 0 -> (n >= 1)%nat ->
  let x := Rpower (m1 / m2) (1 / INR n) in
  (x * (1 + e) / (x + 1)) ^ n = (1 + e) ^ n * m1 / amount m1 m2 n.
Proof.
  intros m1 m2 e n h1 h2 hn x. assert (hx : 0 < x) by apply exp_pos.
  replace (x * (1 + e) / (x + 1)) with ((1 + e) * (x / (x + 1))) by (field; lra).
  unfold x. rewrite ratio_part by assumption. rewrite Rpow_mult_distr. unfold Rdiv at 1. rewrite Rpow_mult_distr, pow_inv.
  rewrite root_power by assumption. unfold amount. field. apply pow_nonzero. pos.
Qed.

Theorem eq25 : statements.eq25.
Proof.
  start. rewrite (last_velocity m1 m2 e (n + 1)) by (try assumption; lia). rewrite !double_power.
  fold (amount m1 m2 (n + 1)). assert (ha := amount_pos m1 m2 (n + 1)). field. lra.
Qed.

Theorem eq25_defined : statements.eq25_defined.
Proof. values. Qed.

(** One more collision: the share rises exactly if L_n <= e. *)
Lemma one_more : forall m1 m2 e n, m1 > 0 -> m2 > 0 -> 0 <= e ->
  ((1 + e) ^ (2 * (n + 1)) * m1 * m2 / amount m1 m2 (n + 1) ^ 2 >= (1 + e) ^ (2 * n) * m1 * m2 / amount m1 m2 n ^ 2
  <-> amount m1 m2 (n + 1) / amount m1 m2 n - 1 <= e).
Proof.
  intros m1 m2 e n h1 h2 he. assert (ha := amount_pos m1 m2 n). assert (hb := amount_pos m1 m2 (n + 1)).
  set (A := amount m1 m2 n) in *. set (B := amount m1 m2 (n + 1)) in *.
  replace ((1 + e) ^ (2 * (n + 1)) * m1 * m2) with ((1 + e) ^ (2 * n) * m1 * m2 * (1 + e) ^ 2)
    by (rewrite !double_power, pow_add; ring).
  rewrite helps by pos. split; intro; lra.
Qed.

Theorem eq19 : statements.eq19.
Proof.
  start. rewrite (double_power (Rpower _ _ + _)), (double_power (Rpower m1 (1 / INR n) + _)).
  fold (amount m1 m2 n). fold (amount m1 m2 (n + 1)). apply one_more; try assumption; lra.
Qed.

Theorem eq19_defined : statements.eq19_defined.
Proof. values. Qed.

Theorem p_elastic : statements.p_elastic.
Proof.
  start. rewrite !double_power. fold (amount m1 m2 n). fold (amount m1 m2 (n + 1)).
  assert (ha := amount_pos m1 m2 n). assert (hb := amount_pos m1 m2 (n + 1)).
  assert (weak := amount_doubles m1 m2 H H0 n H1). assert (strict := amount_doubles_strict m1 m2 H H0 n H1).
  assert (p : 0 < 2 ^ n) by pos.
  replace ((2 ^ (n + 1)) ^ 2 * m1 * m2) with (m1 * m2 * (2 * 2 ^ n) ^ 2) by (rewrite pow_add; ring).
  replace ((2 ^ n) ^ 2 * m1 * m2) with (m1 * m2 * (2 ^ n) ^ 2) by ring. split.
  - apply shares_compared; try pos. apply Rle_ge.
    apply (Rmult_le_compat_l (2 ^ n)) in weak; lra.
  - rewrite shares_strict by pos. split; intro h.
    + intro eq. subst m2. rewrite !amount_equal in h by (try assumption; try lia; reflexivity). rewrite pow_add in h. lra.
    + specialize (strict h). apply (Rmult_lt_compat_l (2 ^ n)) in strict; lra.
Qed.

Theorem p_elastic_defined : statements.p_elastic_defined.
Proof. values. Qed.

Theorem b_positive : statements.b_positive.
Proof. start. apply amount_rises; assumption. Qed.

Theorem b_positive_defined : statements.b_positive_defined.
Proof. values. Qed.

Theorem p_inelastic : statements.p_inelastic.
Proof.
  start. rewrite !double_power. fold (amount m1 m2 n). fold (amount m1 m2 (n + 1)).
  assert (ha := amount_pos m1 m2 n). assert (r := amount_rises m1 m2 H H0 n H1). assert (m : 0 < m1 * m2) by pos.
  apply quotient_lt_iff; [pos | pos |]. apply Rmult_lt_compat_l; [exact m |].
  cbn. rewrite !Rmult_1_r. apply Rmult_le_0_lt_compat; lra.
Qed.

Theorem p_inelastic_defined : statements.p_inelastic_defined.
Proof. values. Qed.

Lemma product_over_mult : forall a b f g,
  product_over a b (fun i => f i * g i) = product_over a b f * product_over a b g.
Proof.
  intros a b f g. unfold product_over. generalize (b + 1 - a)%nat as c. induction c as [| c ih]; cbn; [ring |].
  rewrite ih. ring.
Qed.

Theorem p_indep : statements.p_indep.
Proof.
  start. set (part := fun (m : nat -> R) i => m i / (m i + m (i + 1)%nat)).
  assert (split_off : forall (d m : nat -> R),
    product_over 0 n (fun i => (1 + d i) * m i / (m i + m (i + 1)%nat))
    = product_over 0 n (fun i => 1 + d i) * product_over 0 n (part m)).
  { intros d m. rewrite <- product_over_mult. apply product_over_ext; [lia |]. intros k _. unfold part, Rdiv. ring. }
  rewrite !split_off.
  assert (pe : 0 < product_over 0 n (fun i => 1 + e i)) by (apply product_over_pos; intro k; specialize (H1 k); lra).
  assert (pf : 0 < product_over 0 n (fun i => 1 + f i)) by (apply product_over_pos; intro k; specialize (H2 k); lra).
  assert (pm : 0 < product_over 0 n (part mu)) by (apply product_over_pos; intro k; unfold part; pos; apply H).
  assert (pn : 0 < product_over 0 n (part nu)) by (apply product_over_pos; intro k; unfold part; pos; apply H0).
  set (E := product_over 0 n (fun i => 1 + e i)) in *. set (F := product_over 0 n (fun i => 1 + f i)) in *.
  set (M := product_over 0 n (part mu)) in *. set (K := product_over 0 n (part nu)) in *. split; [field; lra |].
  assert (common : forall c, 0 < c -> ((c * M) ^ 2 <= (c * K) ^ 2 <-> M <= K)).
  { intros c hc. assert (0 < c * M) by pos. assert (0 < c * K) by pos. rewrite square_le_iff by lra. split; intro h.
    - apply Rmult_le_reg_l with c; lra.
    - apply Rmult_le_compat_l; lra. }
  rewrite !common by assumption. reflexivity.
Qed.

Theorem p_indep_defined : statements.p_indep_defined.
Proof.
  start. assert (p : forall (d m : nat -> R), (forall k, 0 <= d k <= 1) -> (forall k, m k > 0) ->
    product_over 0 n (fun i => (1 + d i) * m i / (m i + m (i + 1)%nat)) <> 0).
  { intros d m hd hm. apply Rgt_not_eq, product_over_pos. intro k. specialize (hd k). assert (a := hm k).
    assert (b := hm (k + 1)%nat). pos. }
  repeat split; intros; try (apply p; assumption); pos; auto.
Qed.

(** ** Thresholds *)

Lemma quotient_rises : forall m1 m2 n, m1 > 0 -> m2 > 0 -> (n >= 1)%nat ->
  amount m1 m2 (n + 1) / amount m1 m2 n <= amount m1 m2 (n + 2) / amount m1 m2 (n + 1) /\
  (m1 <> m2 -> amount m1 m2 (n + 1) / amount m1 m2 n < amount m1 m2 (n + 2) / amount m1 m2 (n + 1)).
Proof.
  intros m1 m2 n h1 h2 hn. assert (ha := amount_pos m1 m2 n). assert (hb := amount_pos m1 m2 (n + 1)).
  assert (c := amount_log_convex m1 m2 h1 h2 n hn). split.
  - apply quotient_le; lra.
  - intro hd. assert (s := amount_log_convex_strict m1 m2 h1 h2 n hn hd). apply quotient_lt_iff; lra.
Qed.

Theorem b_grow : statements.b_grow.
Proof.
  start. fold (amount m1 m2 n). fold (amount m1 m2 (n + 1)). fold (amount m1 m2 (n + 1 + 1)).
  replace (n + 1 + 1)%nat with (n + 2)%nat by lia.
  destruct (quotient_rises m1 m2 n H H0 H1) as [weak strict]. split; [lra |]. intro hd. specialize (strict hd). lra.
Qed.

Theorem b_grow_defined : statements.b_grow_defined.
Proof. values. Qed.

Theorem b_grow_bounded : statements.b_grow_bounded.
Proof.
  start. fold (amount m1 m2 n). fold (amount m1 m2 (n + 1)).
  split; [now apply amount_doubles | now apply amount_doubles_strict].
Qed.

Theorem b_grow_bounded_defined : statements.b_grow_bounded_defined.
Proof. values. Qed.

Theorem b_best : statements.b_best.
Proof.
  start. rewrite (double_power (Rpower m1 (1 / INR (n + 2)) + _)), (double_power (Rpower m1 (1 / INR (n + 1)) + _)),
    (double_power (Rpower m1 (1 / INR n) + _)).
  fold (amount m1 m2 n). fold (amount m1 m2 (n + 1)). fold (amount m1 m2 (n + 2)).
  assert (here := one_more m1 m2 e n H H0 ltac:(lra)). assert (next := one_more m1 m2 e (n + 1) H H0 ltac:(lra)).
  replace (n + 1 + 1)%nat with (n + 2)%nat in next by lia.
  destruct (quotient_rises m1 m2 n H H0 H2) as [weak _]. split; [| split].
  - intro h. apply here. apply next in h. lra.
  - exact here.
  - intros <-. rewrite !amount_equal by (try assumption; try lia; reflexivity). rewrite pow_add, pow_1. field.
    assert (0 < 2 ^ n) by pos. lra.
Qed.

Theorem b_best_defined : statements.b_best_defined.
Proof. values. Qed.

Lemma later_quotients : forall m1 m2 n j, m1 > 0 -> m2 > 0 -> (n >= 1)%nat ->
  amount m1 m2 (n + 1) / amount m1 m2 n <= amount m1 m2 (n + j + 1) / amount m1 m2 (n + j).
Proof.
  intros m1 m2 n j h1 h2 hn. induction j as [| j ih]; [rewrite Nat.add_0_r; lra |].
  destruct (quotient_rises m1 m2 (n + j) h1 h2 ltac:(lia)) as [weak _].
  replace (n + S j)%nat with (n + j + 1)%nat by lia. replace (n + j + 1 + 1)%nat with (n + j + 2)%nat by lia. lra.
Qed.

Theorem b_best_after : statements.b_best_after.
Proof.
  start. fold (amount m1 m2 N) in *. fold (amount m1 m2 (N + 1)) in *. fold (amount m1 m2 (N + j)).
  fold (amount m1 m2 (N + j + 1)). assert (l := later_quotients m1 m2 N j H H0 H2). lra.
Qed.

Theorem b_best_after_defined : statements.b_best_after_defined.
Proof. values. Qed.

Theorem b_final : statements.b_final.
Proof.
  start. assert (hn := INR_pos n H1). set (z := Rpower x (1 / INR n)).
  assert (hz : 0 < z) by apply exp_pos. assert (zn : z ^ n = x) by (apply root_power; assumption).
  replace (Rpower x (INR (n + 1) / INR n)) with (x * z) in H2.
  2: { rewrite plus_INR. cbn [INR]. replace ((INR n + 1) / INR n) with (1 + 1 / INR n) by (field; lra).
       rewrite Rpower_plus, Rpower_1 by assumption. reflexivity. }
  assert (hd : 0 < (1 + x * z) ^ n) by pos.
  assert (q : (1 + x) ^ (n + 1) / (1 + x * z) ^ n <= 1 + e) by lra.
  assert (q' : (1 + x) * (1 + x) ^ n <= (1 + e) * (1 + x * z) ^ n).
  { replace ((1 + x) * (1 + x) ^ n) with ((1 + x) ^ (n + 1) / (1 + x * z) ^ n * (1 + x * z) ^ n)
      by (rewrite pow_add; field; lra).
    apply Rmult_le_compat_r; lra. }
  clear H2 q. destruct (Rle_lt_dec x 1) as [s | s].
  - left. assert (z1 : z <= 1).
    { apply Rnot_lt_le. intro g. assert (1 < z ^ n) by (apply Rlt_pow_R1; [exact g | lia]). lra. }
    assert (p : (1 + x * z) ^ n <= (1 + x) ^ n) by (apply pow_incr; nra).
    assert (hp : 0 < (1 + x) ^ n) by pos.
    assert ((1 + e) * (1 + x * z) ^ n <= (1 + e) * (1 + x) ^ n) by (apply Rmult_le_compat_l; lra).
    assert (1 + x <= 1 + e) by (apply Rmult_le_reg_r with ((1 + x) ^ n); lra). lra.
  - right. assert (z1 : 1 <= z).
    { apply Rnot_lt_le. intro g. assert (z ^ n <= 1 ^ n) by (apply pow_incr; lra). rewrite pow1 in *. lra. }
    assert (p : (1 + x * z) ^ n <= (z * (1 + x)) ^ n) by (apply pow_incr; nra).
    rewrite Rpow_mult_distr, zn in p. assert (hp : 0 < (1 + x) ^ n) by pos.
    assert ((1 + e) * (1 + x * z) ^ n <= (1 + e) * (x * (1 + x) ^ n)) by (apply Rmult_le_compat_l; lra).
    assert (1 + x <= (1 + e) * x) by (apply Rmult_le_reg_r with ((1 + x) ^ n); lra). lra.
Qed.

(** ** The best chain *)

Theorem lemma_tangent : statements.lemma_tangent.
Proof. start. split; [now apply tangent | now apply tangent_strict]. Qed.

Theorem lemma_tangent_defined : statements.lemma_tangent_defined.
Proof. values. Qed.

Theorem lemma_chain : statements.lemma_chain.
Proof.
  start. assert (h := chain_tangent mu r (r / (1 + r)) H H0 eq_refl n). unfold linked in h.
  rewrite <- Rpower_mult, Rpower_pow by pos. rewrite Rmult_assoc. exact h.
Qed.

Theorem lemma_chain_defined : statements.lemma_chain_defined.
Proof. start. repeat split; pos; auto. Qed.

Theorem lemma_chain_last : statements.lemma_chain_last.
Proof.
  start. assert (h := chain_tangent_strict mu r (r / (1 + r)) H H0 eq_refl j j (le_n j) H1). unfold linked in h.
  rewrite <- Rpower_mult, Rpower_pow by pos. rewrite Rmult_assoc. exact h.
Qed.

Theorem lemma_chain_last_defined : statements.lemma_chain_last_defined.
Proof. start. repeat split; pos; auto. Qed.

Theorem lemma_chain_strict : statements.lemma_chain_strict.
Proof.
  start. assert (h := chain_tangent_strict mu r (r / (1 + r)) H H0 eq_refl (j + k) j ltac:(lia) H1). unfold linked in h.
  rewrite <- Rpower_mult, Rpower_pow by pos. rewrite Rmult_assoc. exact h.
Qed.

Theorem lemma_chain_strict_defined : statements.lemma_chain_strict_defined.
Proof. start. repeat split; pos; auto. Qed.

Theorem b_global : statements.b_global.
Proof.
  start. assert (pe : 0 < product_over 0 n (fun i => (1 + e i) ^ 2)).
  { apply product_over_pos. intro k. specialize (H0 k). pos. }
  assert (pm : 0 < product_over 1 n mu) by (apply product_over_pos; intro; apply H).
  assert (a := H 0%nat). assert (b := H (n + 1)%nat).
  rewrite double_power. apply (best_share _ (product_over 1 n mu) _ (linked mu n)); try pos.
  apply Rge_le. exact (chain_bound mu n H).
Qed.

Theorem b_global_defined : statements.b_global_defined.
Proof.
  start. assert (a := H 0%nat). assert (b := H (n + 1)%nat). repeat split; try pos.
  apply Rgt_not_eq. exact (linked_pos mu n H).
Qed.

Theorem b_global_unique : statements.b_global_unique.
Proof.
  start. assert (pe : 0 < product_over 0 (j + k) (fun i => (1 + e i) ^ 2)).
  { apply product_over_pos. intro i. specialize (H0 i). pos. }
  assert (pm : 0 < product_over 1 (j + k) mu) by (apply product_over_pos; intro; apply H).
  assert (a := H 0%nat). assert (b := H (j + k + 1)%nat).
  assert (strict := chain_bound_strict mu (j + k) H j ltac:(lia) H1).
  rewrite double_power.
  destruct (best_share (product_over 0 (j + k) (fun i => (1 + e i) ^ 2) * mu 0%nat * mu (j + k + 1)%nat)
    (product_over 1 (j + k) mu) ((Rpower (mu 0%nat) (1 / INR (j + k + 1)) + Rpower (mu (j + k + 1)%nat) (1 / INR (j + k + 1)))
      ^ (j + k + 1)) (linked mu (j + k))) as [le eq]; try pos; try lra.
  destruct le as [le | le]; [exact le |]. apply eq in le. lra.
Qed.

Theorem b_global_unique_defined : statements.b_global_unique_defined.
Proof.
  start. assert (a := H 0%nat). assert (b := H (j + k + 1)%nat). repeat split; try pos.
  apply Rgt_not_eq. exact (linked_pos mu (j + k) H).
Qed.
