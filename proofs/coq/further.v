(** What goes beyond the claim files: the mean and Hölder inequalities for two values that the prover
    rests on, equality in the bound of a chain, the best number of bodies, and one theorem from the
    laws of a collision to (25). *)

From Carom Require Import vocabulary weighted_mean chain threshold tactics collision transfer many limit.
From Coq Require Import Lra Lia.

(** ** The inequalities that the prover takes as known *)

Theorem mean_of_two : forall a b p, a > 0 -> b > 0 -> 0 <= p <= 1 ->
  Rpower a (1 - p) * Rpower b p <= (1 - p) * a + p * b /\
  (a <> b -> 0 < p < 1 -> Rpower a (1 - p) * Rpower b p < (1 - p) * a + p * b).
Proof.
  intros a b p ha hb hp.
  assert (v : Rpower a (1 - p) * Rpower b p = a * exp (p * ln (b / a))).
  { unfold Rpower. rewrite <- exp_plus, ln_div by assumption. rewrite <- (exp_ln a) at 2 by exact ha.
    rewrite <- exp_plus. f_equal. ring. }
  assert (w : (1 - p) * a + p * b = a * ((1 - p) + p * exp (ln (b / a)))).
  { rewrite exp_ln by pos. field. lra. }
  rewrite v, w. split.
  - apply Rmult_le_compat_l; [lra | now apply mean_exp].
  - intros hd hs. apply Rmult_lt_compat_l; [exact ha |]. apply mean_exp_strict; [exact hs |].
    intro z. apply hd. rewrite <- ln_1 in z. apply ln_inv in z; [| pos | lra].
    symmetry. apply (quotient_one b a ha). exact z.
Qed.

Theorem hoelder_of_two : forall a b c d p, a > 0 -> b > 0 -> c > 0 -> d > 0 -> 0 <= p <= 1 ->
  Rpower a (1 - p) * Rpower c p + Rpower b (1 - p) * Rpower d p <= Rpower (a + b) (1 - p) * Rpower (c + d) p /\
  (a * d <> b * c -> 0 < p < 1 ->
   Rpower a (1 - p) * Rpower c p + Rpower b (1 - p) * Rpower d p < Rpower (a + b) (1 - p) * Rpower (c + d) p).
Proof.
  intros a b c d p ha hb hc hd hp. set (S := a + b). set (T := c + d).
  assert (hS : S > 0) by (unfold S; lra). assert (hT : T > 0) by (unfold T; lra).
  assert (k : 0 < Rpower S (1 - p) * Rpower T p) by pos.
  assert (part : forall x y, x > 0 -> y > 0 -> Rpower x (1 - p) * Rpower y p
    = Rpower S (1 - p) * Rpower T p * (Rpower (x / S) (1 - p) * Rpower (y / T) p)).
  { intros x y hx hy. rewrite !root_quotient by assumption. field. split; pos. }
  rewrite (part a c), (part b d) by assumption.
  destruct (mean_of_two (a / S) (c / T) p ltac:(pos) ltac:(pos) hp) as [w1 s1].
  destruct (mean_of_two (b / S) (d / T) p ltac:(pos) ltac:(pos) hp) as [w2 s2].
  assert (one : (1 - p) * (a / S) + p * (c / T) + ((1 - p) * (b / S) + p * (d / T)) = 1).
  { transitivity ((1 - p) * ((a + b) / S) + p * ((c + d) / T)); [field; lra |]. fold S T. field. lra. }
  set (u := Rpower (a / S) (1 - p) * Rpower (c / T) p) in *. set (w := Rpower (b / S) (1 - p) * Rpower (d / T) p) in *.
  set (K := Rpower S (1 - p) * Rpower T p) in *. rewrite <- Rmult_plus_distr_l. rewrite <- (Rmult_1_r K) at 2 4. split.
  - apply Rmult_le_compat_l; lra.
  - intros hn hs. apply Rmult_lt_compat_l; [exact k |].
    assert (ne : a / S <> c / T).
    { intro e. apply hn. apply (quotient_eq_iff a S c T hS hT) in e. unfold S, T in e. lra. }
    specialize (s1 ne hs). lra.
Qed.

(** ** The bound of a chain, with equality *)

Theorem best_chain : forall (n : nat) (mu e : nat -> R), (forall k, mu k > 0) -> (forall k, 0 <= e k <= 1) ->
  let N := (n + 1)%nat in
  let m1 := mu 0%nat in
  let m2 := mu N in
  let eta := product_over 0 n (fun i => (1 + e i) ^ 2) * m1 * m2 * product_over 1 n mu ^ 2
    / product_over 0 n (fun i => mu i + mu (i + 1)%nat) ^ 2 in
  let best := product_over 0 n (fun i => (1 + e i) ^ 2) * m1 * m2
    / (Rpower m1 (1 / INR N) + Rpower m2 (1 / INR N)) ^ (2 * N) in
  eta <= best /\
  (eta = best <-> forall i, (i <= N)%nat -> mu i = Rpower m1 ((INR N - INR i) / INR N) * Rpower m2 (INR i / INR N)).
Proof.
  intros n mu e hm he N m1 m2 eta best.
  assert (pe : 0 < product_over 0 n (fun i => (1 + e i) ^ 2)).
  { apply product_over_pos. intro k. specialize (he k). pos. }
  assert (pm : 0 < product_over 1 n mu) by (apply product_over_pos; intro; apply hm).
  assert (a := hm 0%nat). assert (b := hm N).
  assert (bound := chain_bound mu n hm). fold N m1 m2 in bound. apply Rge_le in bound.
  unfold eta, best. rewrite double_power.
  change (product_over 0 n (fun i => mu i + mu (i + 1)%nat)) with (linked mu n).
  destruct (best_share (product_over 0 n (fun i => (1 + e i) ^ 2) * m1 * m2) (product_over 1 n mu)
    ((Rpower m1 (1 / INR N) + Rpower m2 (1 / INR N)) ^ N) (linked mu n)) as [le eq]; try exact bound; try pos.
  split; [exact le |]. rewrite eq. assert (g := geometric_masses mu n hm). unfold m1, m2, N. rewrite <- g. split.
  - intros h i hi. destruct (Req_dec (mu (i + 1)%nat) (mu i * Rpower (mu (n + 1)%nat / mu 0%nat) (1 / INR (n + 1))))
      as [q | q]; [exact q |].
    assert (s := chain_bound_strict mu n hm i hi q). unfold m1, m2, N in h. lra.
  - intro h. exact (chain_attained mu n hm h).
Qed.

(** ** The best number of bodies *)

Section Best.
Variables m1 m2 e : R.
Hypotheses (h1 : m1 > 0) (h2 : m2 > 0) (he : 0 <= e < 1).

Let L n := amount m1 m2 (n + 1) / amount m1 m2 n - 1.
Let eta k := (1 + e) ^ (2 * k) * m1 * m2 / amount m1 m2 k ^ 2.

Lemma crossing_exists : exists n, e < L (S n).
Proof.
  assert (l := b_grow_limit m2 (m1 / m2) h2 ltac:(pos) 1%nat (le_n 1)).
  replace (m1 / m2 * m2) with m1 in l by (field; lra).
  assert (hl : 0 < 1 - e) by lra. apply is_lim_seq_spec in l. destruct (l (mkposreal _ hl)) as [n hn].
  exists n. specialize (hn (S n) ltac:(lia)). cbn [pos] in hn. apply Rabs_def2 in hn. unfold L, amount. lra.
Qed.

Lemma least : forall n, e < L (S n) -> exists k, e < L (S k) /\ forall j, (j < k)%nat -> L (S j) <= e.
Proof.
  induction n as [n ih] using lt_wf_ind. intro h.
  destruct (Classical_Prop.classic (exists j, (j < n)%nat /\ e < L (S j))) as [[j [hj lj]] | none].
  - exact (ih j hj lj).
  - exists n. split; [exact h |]. intros j hj. apply Rnot_lt_le. intro g. apply none. exists j. tauto.
Qed.

Lemma rises : forall n j, (n >= 1)%nat -> L n <= L (n + j).
Proof. intros n j hn. unfold L. assert (q := later_quotients m1 m2 n j h1 h2 hn). lra. Qed.

Lemma step_weak : forall n, eta (n + 1) >= eta n <-> L n <= e.
Proof. intro n. apply one_more; try assumption. lra. Qed.

Lemma step_strict : forall n, eta (n + 1) > eta n <-> L n < e.
Proof.
  intro n. assert (ha := amount_pos m1 m2 n). assert (hb := amount_pos m1 m2 (n + 1)). unfold eta, L.
  set (A := amount m1 m2 n) in *. set (B := amount m1 m2 (n + 1)) in *.
  assert (p : 0 < (1 + e) ^ n) by pos. assert (m : 0 < m1 * m2) by pos.
  replace ((1 + e) ^ (2 * (n + 1)) * m1 * m2) with (m1 * m2 * ((1 + e) ^ n * (1 + e)) ^ 2)
    by (rewrite !double_power, pow_add; ring).
  replace ((1 + e) ^ (2 * n) * m1 * m2) with (m1 * m2 * ((1 + e) ^ n) ^ 2) by (rewrite double_power; ring).
  rewrite shares_strict by pos. split; intro h.
  - assert (B < (1 + e) * A) by (apply Rmult_lt_reg_l with ((1 + e) ^ n); lra).
    assert (q : B / A < (1 + e) / 1) by (apply quotient_lt_iff; lra). lra.
  - assert (q : B / A < (1 + e) / 1) by lra. apply (proj1 (quotient_lt_iff B A (1 + e) 1 ha ltac:(lra))) in q.
    apply Rlt_gt. rewrite Rmult_assoc. apply Rmult_lt_compat_l; lra.
Qed.

Theorem best_number_exists : exists nstar,
  (forall n, (n >= 1)%nat -> (L n <= e <-> (n <= nstar)%nat)) /\
  (forall k, (k >= 1)%nat -> eta k <= eta (nstar + 1)) /\
  (forall k, (k >= 1)%nat -> eta k = eta (nstar + 1) -> k = (nstar + 1)%nat \/ (k = nstar /\ L nstar = e)).
Proof.
  destruct crossing_exists as [n0 h0]. destruct (least n0 h0) as [s [above below]]. exists s.
  assert (count : forall n, (n >= 1)%nat -> (L n <= e <-> (n <= s)%nat)).
  { intros n hn. split; intro h.
    - destruct (Nat.le_gt_cases n s) as [l | g]; [exact l |]. exfalso.
      assert (r := rises (S s) (n - S s) ltac:(lia)). replace (S s + (n - S s))%nat with n in r by lia. lra.
    - replace n with (S (n - 1)) by lia. apply below. lia. }
  assert (up : forall j, (j <= s)%nat -> eta (s + 1 - j) <= eta (s + 1)).
  { induction j as [| j ih]; intro hj; [rewrite Nat.sub_0_r; lra |].
    assert (c := proj2 (step_weak (s + 1 - S j)) (proj2 (count (s + 1 - S j)%nat ltac:(lia)) ltac:(lia))).
    replace (s + 1 - S j + 1)%nat with (s + 1 - j)%nat in c by lia. specialize (ih ltac:(lia)). lra. }
  assert (down : forall j, eta (s + 1 + j + 1) < eta (s + 1)).
  { induction j as [| j ih].
    - rewrite Nat.add_0_r. apply Rnot_le_lt. intro g. apply Rle_ge in g. apply step_weak in g.
      apply (proj1 (count (s + 1)%nat ltac:(lia))) in g. lia.
    - apply Rlt_trans with (2 := ih). apply Rnot_le_lt. intro g. apply Rle_ge in g.
      replace (s + 1 + S j)%nat with (s + 1 + j + 1)%nat in g by lia. apply step_weak in g.
      apply (proj1 (count (s + 1 + j + 1)%nat ltac:(lia))) in g. lia. }
  split; [exact count |]. split.
  - intros k hk. destruct (Nat.le_gt_cases k (s + 1)) as [l | g].
    + replace k with (s + 1 - (s + 1 - k))%nat by lia. apply up. lia.
    + left. replace k with (s + 1 + (k - s - 2) + 1)%nat by lia. apply down.
  - intros k hk tie. destruct (Nat.le_gt_cases k (s + 1)) as [l | g].
    + destruct (Nat.eq_dec k (s + 1)) as [-> | ne]; [now left | right].
      assert (lk := proj2 (count k hk) ltac:(lia)).
      assert (not_lt : ~ L k < e).
      { intro lt. apply step_strict in lt. assert (u := up (s + 1 - (k + 1))%nat ltac:(lia)).
        replace (s + 1 - (s + 1 - (k + 1)))%nat with (k + 1)%nat in u by lia. lra. }
      assert (eq : L k = e) by lra. destruct (Nat.eq_dec k s) as [-> | ne']; [tauto | exfalso].
      destruct (Req_dec m1 m2) as [em | nm].
      * unfold L in eq. rewrite !amount_equal in eq by (try assumption; try lia). rewrite pow_add, pow_1 in eq.
        replace (m1 * (2 ^ k * 2) / (m1 * 2 ^ k) - 1) with 1 in eq by (field; split; pos). lra.
      * assert (q := proj2 (quotient_rises m1 m2 k h1 h2 hk) nm).
        assert (le := proj2 (count (k + 1)%nat ltac:(lia)) ltac:(lia)). unfold L in *.
        replace (k + 1 + 1)%nat with (k + 2)%nat in le by lia. lra.
    + exfalso. assert (d := down (k - s - 2)%nat). replace (s + 1 + (k - s - 2) + 1)%nat with k in d by lia. lra.
Qed.

End Best.

Theorem best_number : forall m1 m2 e, m1 > 0 -> m2 > 0 -> 0 <= e < 1 ->
  let S := fun k : nat => Rpower m1 (1 / INR k) + Rpower m2 (1 / INR k) in
  let L := fun n : nat => S (n + 1)%nat ^ (n + 1) / S n ^ n - 1 in
  let eta := fun k : nat => (1 + e) ^ (2 * k) * m1 * m2 / S k ^ (2 * k) in
  exists nstar : nat,
  (forall n : nat, (n >= 1)%nat -> (L n <= e <-> (n <= nstar)%nat)) /\
  (forall k : nat, (k >= 1)%nat -> eta k <= eta (nstar + 1)%nat) /\
  (forall k : nat, (k >= 1)%nat -> eta k = eta (nstar + 1)%nat ->
    k = (nstar + 1)%nat \/ (k = nstar /\ L nstar = e)).
Proof.
  intros m1 m2 e h1 h2 he. cbv zeta.
  destruct (best_number_exists m1 m2 e h1 h2 he) as (s & count & most & tie). exists s.
  assert (v : forall k, (1 + e) ^ (2 * k) * m1 * m2 / (Rpower m1 (1 / INR k) + Rpower m2 (1 / INR k)) ^ (2 * k)
    = (1 + e) ^ (2 * k) * m1 * m2 / amount m1 m2 k ^ 2).
  { intro k. unfold amount. now rewrite <- double_power. }
  split; [exact count |]. split.
  - intros k hk. rewrite !v. now apply most.
  - intros k hk. rewrite !v. now apply tie.
Qed.

Theorem always_helps : forall m1 m2 n, m1 > 0 -> m2 > 0 -> (n >= 1)%nat ->
  let S := fun k : nat => Rpower m1 (1 / INR k) + Rpower m2 (1 / INR k) in
  0 < S (n + 1)%nat ^ (n + 1) / S n ^ n - 1 <= 1.
Proof.
  intros m1 m2 n h1 h2 hn. cbv beta zeta. fold (amount m1 m2 n). fold (amount m1 m2 (n + 1)).
  assert (a := amount_pos m1 m2 n). assert (up := amount_doubles m1 m2 h1 h2 n hn).
  assert (low := amount_rises m1 m2 h1 h2 n hn). split.
  - assert (q : amount m1 m2 n / amount m1 m2 n < amount m1 m2 (n + 1) / amount m1 m2 n)
      by (apply quotient_lt_iff; [lra | lra |]; apply Rmult_lt_compat_r; lra).
    rewrite (proj2 (quotient_one _ _ a) eq_refl) in q. lra.
  - assert (q : amount m1 m2 (n + 1) / amount m1 m2 n <= 2 / 1)
      by (apply quotient_le; lra). lra.
Qed.

(** ** From the laws of a collision to (25) *)

Section Laws.
Variables (n : nat) (mu e : nat -> R) (v1 : R) (v : nat -> nat -> R).
Hypotheses (hm : forall k, mu k > 0) (he : forall k, 0 <= e k <= 1).
Hypothesis moving : v 0%nat 0%nat = v1.
Hypothesis resting : forall i, (1 <= i <= n + 1)%nat -> v 0%nat i = 0.
Hypothesis collision : forall t, (t <= n)%nat ->
  mu t * v t t + mu (t + 1)%nat * v t (t + 1)%nat
    = mu t * v (t + 1)%nat t + mu (t + 1)%nat * v (t + 1)%nat (t + 1)%nat /\
  v (t + 1)%nat (t + 1)%nat - v (t + 1)%nat t = - (e t * (v t (t + 1)%nat - v t t)) /\
  (forall i, (i <= n + 1)%nat -> i <> t -> i <> (t + 1)%nat -> v (t + 1)%nat i = v t i).

Lemma ahead : forall t i, (t <= n + 1)%nat -> (t < i <= n + 1)%nat -> v t i = 0.
Proof.
  induction t as [| t ih]; intros i ht hi; [apply resting; lia |].
  destruct (collision t ltac:(lia)) as (_ & _ & same). replace (S t) with (t + 1)%nat by lia.
  rewrite same by lia. apply ih; lia.
Qed.

Lemma struck : forall t, (t <= n)%nat ->
  v (t + 1)%nat (t + 1)%nat = mu t * (1 + e t) / (mu t + mu (t + 1)%nat) * v t t /\
  v (t + 1)%nat t = (mu t - e t * mu (t + 1)%nat) / (mu t + mu (t + 1)%nat) * v t t.
Proof.
  intros t ht. destruct (collision t ht) as (p & q & _).
  destruct (solution _ _ _ _ _ _ _ (hm t) (hm (t + 1)%nat) p q) as [a b].
  rewrite (ahead t (t + 1)%nat) in a, b by lia. rewrite a, b. split; ring.
Qed.

Lemma kept : forall t i, (i < t)%nat -> (t <= n + 1)%nat -> v t i = v (i + 1)%nat i.
Proof.
  induction t as [| t ih]; intros i hi ht; [lia |]. destruct (Nat.eq_dec i t) as [-> | ne].
  - now replace (S t) with (t + 1)%nat by lia.
  - destruct (collision t ltac:(lia)) as (_ & _ & same). replace (S t) with (t + 1)%nat by lia.
    rewrite same by lia. apply ih; lia.
Qed.

Lemma front : forall t, (t <= n)%nat -> v (t + 1)%nat (t + 1)%nat
  = product_over 0 t (fun i => 1 + e i) * product_over 0 t mu / linked mu t * v1.
Proof.
  assert (lp := fun t => linked_pos mu t hm).
  induction t as [| t ih]; intro ht.
  - rewrite (proj1 (struck 0%nat ltac:(lia))), moving. unfold linked. rewrite !product_over_one.
    assert (a := hm 0%nat). assert (b := hm (0 + 1)%nat). field. lra.
  - rewrite (proj1 (struck (S t) ht)). replace (v (S t) (S t)) with (v (t + 1)%nat (t + 1)%nat) by (now replace (S t) with (t + 1)%nat by lia).
    rewrite ih by lia. rewrite linked_next, !product_over_last by lia. cbv beta.
    assert (a := hm (S t)). assert (b := hm (S t + 1)%nat). specialize (lp t). field. lra.
Qed.

Lemma share_of_front : v1 > 0 ->
  (mu (n + 1)%nat * v (n + 1)%nat (n + 1)%nat ^ 2 / 2) / (mu 0%nat * v1 ^ 2 / 2)
  = product_over 0 n (fun i => (1 + e i) ^ 2) * mu 0%nat * mu (n + 1)%nat * product_over 1 n mu ^ 2 / linked mu n ^ 2.
Proof.
  intro hv. rewrite front by lia. rewrite <- (product_over_square 0 n (fun i => 1 + e i)). rewrite (product_over_first n mu).
  assert (a := hm 0%nat). assert (l := linked_pos mu n hm). field. lra.
Qed.

End Laws.

Theorem from_the_laws : forall (n : nat) (mu e : nat -> R) (v1 : R) (v : nat -> nat -> R),
  (forall k, mu k > 0) -> (forall k, 0 <= e k <= 1) -> v1 > 0 ->
  v 0%nat 0%nat = v1 -> (forall i, (1 <= i <= n + 1)%nat -> v 0%nat i = 0) ->
  (forall t, (t <= n)%nat ->
    mu t * v t t + mu (t + 1)%nat * v t (t + 1)%nat
      = mu t * v (t + 1)%nat t + mu (t + 1)%nat * v (t + 1)%nat (t + 1)%nat /\
    v (t + 1)%nat (t + 1)%nat - v (t + 1)%nat t = - (e t * (v t (t + 1)%nat - v t t)) /\
    (forall i, (i <= n + 1)%nat -> i <> t -> i <> (t + 1)%nat -> v (t + 1)%nat i = v t i)) ->
  let N := (n + 1)%nat in
  let m1 := mu 0%nat in
  let m2 := mu N in
  let eta := (m2 * v N N ^ 2 / 2) / (m1 * v1 ^ 2 / 2) in
  let best := product_over 0 n (fun t => (1 + e t) ^ 2) * m1 * m2
    / (Rpower m1 (1 / INR N) + Rpower m2 (1 / INR N)) ^ (2 * N) in
  eta <= best /\
  (eta = best <-> forall i, (i <= N)%nat -> mu i = Rpower m1 ((INR N - INR i) / INR N) * Rpower m2 (INR i / INR N)).
Proof.
  intros n mu e v1 v hm he hv moving resting collision. cbv zeta.
  rewrite (share_of_front n mu e v1 v hm moving resting collision hv). exact (best_chain n mu e hm he).
Qed.

Theorem to_25 : forall (n : nat) (mu : nat -> R) (e v1 : R) (v : nat -> nat -> R),
  (forall k, mu k > 0) -> 0 <= e <= 1 -> v1 > 0 ->
  v 0%nat 0%nat = v1 -> (forall i, (1 <= i <= n + 1)%nat -> v 0%nat i = 0) ->
  (forall t, (t <= n)%nat ->
    mu t * v t t + mu (t + 1)%nat * v t (t + 1)%nat
      = mu t * v (t + 1)%nat t + mu (t + 1)%nat * v (t + 1)%nat (t + 1)%nat /\
    v (t + 1)%nat (t + 1)%nat - v (t + 1)%nat t = - (e * (v t (t + 1)%nat - v t t)) /\
    (forall i, (i <= n + 1)%nat -> i <> t -> i <> (t + 1)%nat -> v (t + 1)%nat i = v t i)) ->
  let N := (n + 1)%nat in
  let m1 := mu 0%nat in
  let m2 := mu N in
  let x := Rpower (m1 / m2) (1 / INR N) in
  let eta := (m2 * v N N ^ 2 / 2) / (m1 * v1 ^ 2 / 2) in
  let best := (1 + e) ^ (2 * N) * m1 * m2 / (Rpower m1 (1 / INR N) + Rpower m2 (1 / INR N)) ^ (2 * N) in
  let geometric := forall i, (i <= N)%nat ->
    mu i = Rpower m1 ((INR N - INR i) / INR N) * Rpower m2 (INR i / INR N) in
  eta <= best /\
  (eta = best <-> geometric) /\
  (geometric ->
    (forall i, (i <= n)%nat -> v N i = (x * (1 + e)) ^ i * (x - e) / (x + 1) ^ (i + 1) * v1) /\
    v N N = (x * (1 + e) / (x + 1)) ^ N * v1).
Proof.
  intros n mu e v1 v hm he hv moving resting collision. cbv zeta.
  assert (power : product_over 0 n (fun _ : nat => (1 + e) ^ 2) = (1 + e) ^ (2 * (n + 1))).
  { induction n as [| n ih]; [rewrite product_over_one; reflexivity |]. rewrite product_over_last by lia.
    clear -ih. assert (g : forall k, product_over 0 k (fun _ : nat => (1 + e) ^ 2) = (1 + e) ^ (2 * (k + 1))).
    { induction k as [| k ih']; [rewrite product_over_one; reflexivity |]. rewrite product_over_last, ih' by lia.
      rewrite <- pow_add. f_equal. lia. }
    rewrite g, <- pow_add. f_equal. lia. }
  destruct (from_the_laws n mu (fun _ => e) v1 v hm (fun _ => he) hv moving resting collision) as [le eq].
  rewrite power in le, eq. split; [exact le |]. split; [exact eq |]. intro geometric.
  assert (step := proj2 (geometric_masses mu n hm) geometric). clear geometric. rename step into geometric.
  set (x := Rpower (mu 0%nat / mu (n + 1)%nat) (1 / INR (n + 1))).
  assert (a := hm 0%nat). assert (b := hm (n + 1)%nat). assert (hx : 0 < x) by apply exp_pos.
  assert (inverse : Rpower (mu (n + 1)%nat / mu 0%nat) (1 / INR (n + 1)) = / x).
  { unfold x. rewrite !root_quotient by assumption. field. split; pos. }
  rewrite inverse in geometric.
  assert (frontal : forall t, (t <= n + 1)%nat -> v t t = (x * (1 + e) / (x + 1)) ^ t * v1).
  { induction t as [| t ih]; intro ht; [cbn; rewrite moving; ring |]. replace (S t) with (t + 1)%nat by lia.
    rewrite (proj1 (struck n mu (fun _ => e) v hm resting collision t ltac:(lia))), ih by lia.
    rewrite geometric by lia. assert (c := hm t). rewrite pow_add. assert (cx : 0 < mu t * x) by pos. field. repeat split; lra. }
  split; [| apply frontal; lia].
  intros i hi. rewrite (kept n mu (fun _ => e) v collision) by lia.
  rewrite (proj2 (struck n mu (fun _ => e) v hm resting collision i hi)), frontal by lia.
  rewrite geometric by lia. assert (c := hm i). unfold Rdiv at 2. rewrite Rpow_mult_distr, pow_inv, pow_add.
  assert (0 < (x + 1) ^ i) by pos. assert (cx : 0 < mu i * x) by pos. field. repeat split; lra.
Qed.

(** Such runs exist, for all masses and restitutions: the theorems above are not empty. *)
Theorem a_run_exists : forall (n : nat) (mu e : nat -> R) (v1 : R), (forall k, mu k > 0) ->
  exists v : nat -> nat -> R,
  v 0%nat 0%nat = v1 /\ (forall i, (1 <= i <= n + 1)%nat -> v 0%nat i = 0) /\
  (forall t, (t <= n)%nat ->
    mu t * v t t + mu (t + 1)%nat * v t (t + 1)%nat
      = mu t * v (t + 1)%nat t + mu (t + 1)%nat * v (t + 1)%nat (t + 1)%nat /\
    v (t + 1)%nat (t + 1)%nat - v (t + 1)%nat t = - (e t * (v t (t + 1)%nat - v t t)) /\
    (forall i, (i <= n + 1)%nat -> i <> t -> i <> (t + 1)%nat -> v (t + 1)%nat i = v t i)).
Proof.
  intros n mu e v1 hm.
  set (u := fix u (t : nat) : R :=
    match t with O => v1 | S s => mu s * (1 + e s) / (mu s + mu (s + 1)%nat) * u s end).
  set (keep := fun i => (mu i - e i * mu (i + 1)%nat) / (mu i + mu (i + 1)%nat) * u i).
  exists (fun t i => if Nat.ltb i t then keep i else if Nat.eqb i t then u t else 0). split; [reflexivity |]. split.
  - intros i hi. destruct i as [| i]; [lia | reflexivity].
  - intros t ht. rewrite !Nat.ltb_irrefl, !Nat.eqb_refl.
    replace (Nat.ltb (t + 1) t) with false by (symmetry; apply Nat.ltb_ge; lia).
    replace (Nat.eqb (t + 1) t) with false by (symmetry; apply Nat.eqb_neq; lia).
    replace (Nat.ltb t (t + 1)) with true by (symmetry; apply Nat.ltb_lt; lia).
    assert (step : u (t + 1)%nat = mu t * (1 + e t) / (mu t + mu (t + 1)%nat) * u t).
    { replace (t + 1)%nat with (S t) at 1 by lia. reflexivity. }
    assert (a := hm t). assert (b := hm (t + 1)%nat). rewrite step. unfold keep. split; [field; lra |]. split; [field; lra |].
    intros i _ h1 h2. replace (Nat.eqb i (t + 1)) with false by (symmetry; apply Nat.eqb_neq; lia).
    replace (Nat.eqb i t) with false by (symmetry; apply Nat.eqb_neq; lia).
    destruct (Nat.ltb_spec i t) as [l | l].
    + replace (Nat.ltb i (t + 1)) with true by (symmetry; apply Nat.ltb_lt; lia). reflexivity.
    + replace (Nat.ltb i (t + 1)) with false by (symmetry; apply Nat.ltb_ge; lia). reflexivity.
Qed.
