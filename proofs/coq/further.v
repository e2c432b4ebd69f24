(** What no claim file states, proved by hand: the mean and Hölder inequalities for two values that the
    prover rests on, the bound of a chain with its case of equality, the best number of bodies, and one
    theorem from the laws of a collision to (25). What the claim files state is taken from their proofs,
    which are made from certificates: [b_global_unique], [b_best], [b_best_finite], [b_best_after],
    [b_best_elastic], [b_grow], [b_grow_bounded], [b_positive], [eq19] and [eq05_unique]. *)

From Carom Require Import vocabulary.
From Carom Require rules.
From Carom Require b_global_unique b_best b_best_finite b_best_after b_best_elastic.
From Carom Require b_grow b_grow_bounded b_positive eq19 eq05_unique.
From Coq Require Import Lra Lia.

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

(** ** Products over a range *)

Lemma product_over_one : forall a f, product_over a a f = f a.
Proof. intros. unfold product_over. replace (a + 1 - a)%nat with 1%nat by lia. cbn. rewrite Nat.add_0_r. ring. Qed.

Lemma product_over_none : forall a f, product_over (S a) a f = 1.
Proof. intros. unfold product_over. replace (a + 1 - S a)%nat with 0%nat by lia. reflexivity. Qed.

Lemma product_over_last : forall a b f, (a <= S b)%nat -> product_over a (S b) f = product_over a b f * f (S b).
Proof.
  intros a b f h. unfold product_over. replace (S b + 1 - a)%nat with (S (b + 1 - a)) by lia. cbn.
  replace (a + (b + 1 - a))%nat with (S b) by lia. reflexivity.
Qed.

Lemma product_over_first : forall n f, product_over 0 n f = f 0%nat * product_over 1 n f.
Proof.
  intros n f. induction n as [| n ih].
  - rewrite product_over_one, product_over_none. ring.
  - rewrite !product_over_last by lia. rewrite ih. ring.
Qed.

Lemma product_over_pos : forall a b f, (forall k, 0 < f k) -> 0 < product_over a b f.
Proof.
  intros a b f h. unfold product_over. generalize (b + 1 - a)%nat as c. induction c as [| c ih]; cbn.
  - lra.
  - apply Rmult_lt_0_compat; [exact ih | apply h].
Qed.

Lemma product_over_square : forall a b f, product_over a b f ^ 2 = product_over a b (fun k => f k ^ 2).
Proof.
  intros a b f. unfold product_over. generalize (b + 1 - a)%nat as c. induction c as [| c ih]; cbn - [pow].
  - ring.
  - rewrite <- ih. ring.
Qed.


(** ** The inequalities that the prover takes as known *)

Theorem mean_of_two : forall a b p, a > 0 -> b > 0 -> 0 <= p <= 1 ->
  Rpower a (1 - p) * Rpower b p <= (1 - p) * a + p * b /\
  (a <> b -> 0 < p < 1 -> Rpower a (1 - p) * Rpower b p < (1 - p) * a + p * b).
Proof. intros a b p ha hb hp. split; [now apply rules.mean_weak | intros; now apply rules.mean_strict]. Qed.

Lemma root_power : forall a n, a > 0 -> (n >= 1)%nat -> Rpower a (1 / INR n) ^ n = a.
Proof.
  intros a n ha hn. rewrite <- Rpower_pow by pos. rewrite Rpower_mult.
  replace (1 / INR n * INR n) with 1 by (field; pos). apply Rpower_1. exact ha.
Qed.

Lemma root_quotient : forall a b y, a > 0 -> b > 0 -> Rpower (b / a) y = Rpower b y / Rpower a y.
Proof.
  intros a b y ha hb. apply Rmult_eq_reg_r with (Rpower a y); [| pos].
  rewrite Rpower_mult_distr; [| pos | pos]. replace (b / a * a) with b by (field; pos). field. pos.
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
    { intro e. apply hn. assert (z : a * T = c * S).
      { replace (a * T) with (a / S * (S * T)) by (field; lra). rewrite e. field. lra. }
      unfold S, T in z. lra. }
    specialize (s1 ne hs). lra.
Qed.

(** ** The bound of a chain, with equality *)

Section Chain.
Variables (mu : nat -> R) (n : nat).
Hypothesis mu_pos : forall k, mu k > 0.
Let N := (n + 1)%nat.
Let r := Rpower (mu N / mu 0%nat) (1 / INR N).

(** All masses are those of (21) as soon as each is r times the one before it. *)
Lemma geometric_masses : (forall i, (i <= n)%nat -> mu (i + 1)%nat = mu i * r) <->
  (forall i, (i <= n + 1)%nat ->
    mu i = Rpower (mu 0%nat) ((INR N - INR i) / INR N) * Rpower (mu N) (INR i / INR N)).
Proof.
  assert (h0 := mu_pos 0). assert (h1 := mu_pos N). assert (hN : 0 < INR N) by (apply lt_0_INR; unfold N; lia).
  assert (form : forall i, mu 0%nat * r ^ i =
    Rpower (mu 0%nat) ((INR N - INR i) / INR N) * Rpower (mu N) (INR i / INR N)).
  { intro i. unfold r. rewrite root_quotient by assumption. unfold Rdiv at 1. rewrite Rpow_mult_distr.
    rewrite pow_inv. rewrite <- !Rpower_pow by pos. rewrite !Rpower_mult.
    replace (1 / INR N * INR i) with (INR i / INR N) by (field; lra).
    replace ((INR N - INR i) / INR N) with (1 + - (INR i / INR N)) by (field; lra).
    rewrite Rpower_plus, Rpower_Ropp, Rpower_1 by exact h0. field. pos. }
  split.
  - intros h i hi. rewrite <- form. induction i as [| i ih]; [cbn; ring |].
    replace (S i) with (i + 1)%nat by lia. rewrite h by lia. rewrite ih at 1 by lia.
    rewrite pow_add. ring.
  - intros h i hi. rewrite (h (i + 1)%nat), (h i) by lia. rewrite <- !form, pow_add. ring.
Qed.

Definition linked (m : nat -> R) (k : nat) : R := product_over 0 k (fun i => m i + m (i + 1)%nat).

Lemma linked_pos : forall k, 0 < linked mu k.
Proof. intro k. apply product_over_pos. intro i. assert (a := mu_pos i). assert (b := mu_pos (i + 1)%nat). lra. Qed.

(** The share of the geometric chain is the best one. *)
Lemma attained : forall e, (forall i, (i <= n)%nat -> mu (i + 1)%nat = mu i * r) ->
  e * mu 0%nat * mu N * product_over 1 n mu ^ 2 / linked mu n ^ 2
  = e * mu 0%nat * mu N / (Rpower (mu 0%nat) (1 / INR N) + Rpower (mu N) (1 / INR N)) ^ (2 * N).
Proof.
  intros e h. assert (h0 := mu_pos 0). assert (h1 := mu_pos N). assert (hr : 0 < r) by (unfold r; pos).
  assert (g : forall k, (k <= n)%nat -> linked mu k = product_over 0 k mu * (1 + r) ^ (k + 1)).
  { clear -h. induction k as [| k ih]; intro hk.
    - unfold linked. rewrite !product_over_one, (h 0%nat) by lia. generalize r. intro q. simpl. ring.
    - unfold linked in *. rewrite !product_over_last, ih by lia. replace (S k + 1)%nat with (S (k + 1)) by lia.
      rewrite <- tech_pow_Rmult. replace (S (k + 1)) with (S k + 1)%nat by lia. rewrite (h (S k)) by lia. ring. }
  assert (s : Rpower (mu 0%nat) (1 / INR N) + Rpower (mu N) (1 / INR N) = Rpower (mu 0%nat) (1 / INR N) * (1 + r)).
  { unfold r. rewrite root_quotient by assumption. field. pos. }
  assert (p : 0 < product_over 1 n mu) by (apply product_over_pos; intro; apply mu_pos).
  rewrite s, (Nat.mul_comm 2), pow_mult, Rpow_mult_distr, root_power by (try exact h0; unfold N; lia).
  rewrite (g n) by lia. rewrite product_over_first. fold N. assert (q : 0 < (1 + r) ^ N) by (apply pow_lt; lra).
  field. repeat split; lra.
Qed.

End Chain.

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
  assert (equal : (forall i, (i <= n)%nat -> mu (i + 1)%nat = mu i * Rpower (m2 / m1) (1 / INR N)) -> eta = best).
  { intro h. exact (attained mu n hm _ h). }
  assert (below : forall i, (i <= n)%nat -> mu (i + 1)%nat <> mu i * Rpower (m2 / m1) (1 / INR N) -> eta < best).
  { intros i hi hd. assert (b := b_global_unique.b_global_unique mu hm i (n - i)). cbv zeta in b.
    replace (i + (n - i))%nat with n in b by lia. exact (b e he hd). }
  assert (all : (forall i, (i <= n)%nat -> mu (i + 1)%nat = mu i * Rpower (m2 / m1) (1 / INR N)) \/ eta < best).
  { destruct (Classical_Prop.classic (exists i, (i <= n)%nat /\ mu (i + 1)%nat <> mu i * Rpower (m2 / m1) (1 / INR N)))
      as [[i [hi hd]] | none]; [right; exact (below i hi hd) | left].
    intros i hi. apply Classical_Prop.NNPP. intro hd. apply none. now exists i. }
  assert (g := geometric_masses mu n hm). fold N m1 m2 in g.
  split; [destruct all as [h | h]; [right; now apply equal | now left] |]. rewrite <- g. split.
  - intro h. destruct all as [all | all]; [exact all | lra].
  - exact equal.
Qed.

(** ** The best number of bodies *)

Section Best.
Variables m1 m2 e : R.
Hypotheses (h1 : m1 > 0) (h2 : m2 > 0) (he : 0 <= e < 1).

Let s k := Rpower m1 (1 / INR k) + Rpower m2 (1 / INR k).
Let L n := s (n + 1)%nat ^ (n + 1) / s n ^ n - 1.
Let eta k := (1 + e) ^ (2 * k) * m1 * m2 / s k ^ (2 * k).

Lemma sum_pos : forall k, 0 < s k.
Proof. intro k. unfold s. pos. Qed.

Lemma crossing_exists : exists n, e < L (S n).
Proof.
  assert (ordered : forall a b, a > 0 -> b > 0 -> a >= b -> exists n : nat,
    e < (Rpower a (1 / INR (S n + 1)) + Rpower b (1 / INR (S n + 1))) ^ (S n + 1)
      / (Rpower a (1 / INR (S n)) + Rpower b (1 / INR (S n))) ^ S n - 1).
  { intros a b ha hb hab. assert (hr : a / b >= 1).
    { apply Rle_ge, Rmult_le_reg_r with b; [exact hb |]. replace (a / b * b) with a by (field; lra). lra. }
    assert (large := is_lim_seq_INR). apply is_lim_seq_spec in large.
    destruct (large (2 * (a / b - 1) ^ 2 / (1 - e))) as [n hn]. specialize (hn n (le_n n)). exists n.
    assert (f := b_best_finite.b_best_finite b hb (a / b) hr e he (S n) ltac:(lia)). cbv zeta in f.
    replace (a / b * b) with a in f by (field; lra). apply f.
    assert (c : INR (S n) > 2 * (a / b - 1) ^ 2 / (1 - e)) by (rewrite S_INR; lra).
    apply Rmult_gt_compat_r with (r := 1 - e) in c; [| lra].
    replace (2 * (a / b - 1) ^ 2 / (1 - e) * (1 - e)) with (2 * (a / b - 1) ^ 2) in c by (field; lra). exact c. }
  destruct (Rle_lt_dec m2 m1) as [h | h].
  - destruct (ordered m1 m2 h1 h2 ltac:(lra)) as [n hn]. exists n. exact hn.
  - destruct (ordered m2 m1 h2 h1 ltac:(lra)) as [n hn]. exists n. unfold L, s.
    rewrite (Rplus_comm (Rpower m1 (1 / INR (S n + 1)))), (Rplus_comm (Rpower m1 (1 / INR (S n)))). exact hn.
Qed.

Lemma least : forall n, e < L (S n) -> exists k, e < L (S k) /\ forall j, (j < k)%nat -> L (S j) <= e.
Proof.
  induction n as [n ih] using lt_wf_ind. intro h.
  destruct (Classical_Prop.classic (exists j, (j < n)%nat /\ e < L (S j))) as [[j [hj lj]] | none].
  - exact (ih j hj lj).
  - exists n. split; [exact h |]. intros j hj. apply Rnot_lt_le. intro g. apply none. exists j. tauto.
Qed.

Lemma rises : forall n j, (n >= 1)%nat -> L n <= L (n + j).
Proof.
  intros n j hn. induction j as [| j ih]; [rewrite Nat.add_0_r; lra |].
  destruct (b_grow.b_grow m1 m2 h1 h2 (n + j) ltac:(lia)) as [weak _]. cbv beta zeta in weak.
  replace (n + S j)%nat with (n + j + 1)%nat by lia. unfold L, s in *. lra.
Qed.

Lemma step_weak : forall n, (n >= 1)%nat -> (eta (n + 1) >= eta n <-> L n <= e).
Proof. intros n hn. exact (eq19.eq19 m1 m2 h1 h2 e ltac:(lra) n hn). Qed.

(** Where L n < e, one body more helps strictly: with the restitution L n it did no harm. *)
Lemma step_strict : forall n, (n >= 1)%nat -> L n < e -> eta (n + 1) > eta n.
Proof.
  intros n hn h. assert (l : 0 < L n).
  { assert (b := b_positive.b_positive m1 m2 h1 h2 n hn). cbv beta zeta in b. fold (s n) (s (n + 1)) in b.
    assert (a : 0 < s n ^ n) by (apply pow_lt, sum_pos). unfold L. apply Rmult_lt_reg_r with (s n ^ n); [exact a |].
    replace ((s (n + 1)%nat ^ (n + 1) / s n ^ n - 1) * s n ^ n) with (s (n + 1)%nat ^ (n + 1) - s n ^ n) by (field; lra).
    lra. }
  assert (w := proj2 (eq19.eq19 m1 m2 h1 h2 (L n) ltac:(lra) n hn) (Rle_refl _)). cbv beta zeta in w.
  fold (s n) (s (n + 1)) in w. unfold eta. set (A := s n ^ (2 * n)) in *. set (B := s (n + 1)%nat ^ (2 * (n + 1))) in *.
  assert (ha : 0 < A) by (apply pow_lt, sum_pos). assert (hb : 0 < B) by (apply pow_lt, sum_pos).
  replace (2 * (n + 1))%nat with (2 * n + 2)%nat in * by lia. rewrite !pow_add in *.
  set (x := (1 + L n) ^ (2 * n)) in *. set (y := (1 + e) ^ (2 * n)) in *.
  assert (hx : 0 < x) by (apply pow_lt; lra). assert (hy : 0 < y) by (apply pow_lt; lra).
  assert (base : (1 + L n) ^ 2 * (m1 * m2) / B >= m1 * m2 / A).
  { apply Rle_ge, Rmult_le_reg_l with x; [exact hx |]. apply Rge_le in w.
    replace (x * (m1 * m2 / A)) with (x * m1 * m2 / A) by (field; lra).
    replace (x * ((1 + L n) ^ 2 * (m1 * m2) / B)) with (x * (1 + L n) ^ 2 * m1 * m2 / B) by (field; lra). exact w. }
  assert (more : (1 + e) ^ 2 * (m1 * m2) / B > (1 + L n) ^ 2 * (m1 * m2) / B).
  { apply Rmult_lt_compat_r; [now apply Rinv_0_lt_compat |]. apply Rmult_lt_compat_r; [pos |].
    apply rules.rising_pow; lra || lia. }
  replace (y * (1 + e) ^ 2 * m1 * m2 / B) with (y * ((1 + e) ^ 2 * (m1 * m2) / B)) by (field; lra).
  replace (y * m1 * m2 / A) with (y * (m1 * m2 / A)) by (field; lra). apply Rmult_lt_compat_l; lra.
Qed.

Theorem best_number_exists : exists nstar,
  (forall n, (n >= 1)%nat -> (L n <= e <-> (n <= nstar)%nat)) /\
  (forall k, (k >= 1)%nat -> eta k <= eta (nstar + 1)) /\
  (forall k, (k >= 1)%nat -> eta k = eta (nstar + 1) -> k = (nstar + 1)%nat \/ (k = nstar /\ L nstar = e)).
Proof.
  destruct crossing_exists as [n0 h0]. destruct (least n0 h0) as [t [above below]]. exists t.
  assert (count : forall n, (n >= 1)%nat -> (L n <= e <-> (n <= t)%nat)).
  { intros n hn. split; intro h.
    - destruct (Nat.le_gt_cases n t) as [l | g]; [exact l |]. exfalso.
      assert (r := rises (S t) (n - S t) ltac:(lia)). replace (S t + (n - S t))%nat with n in r by lia. lra.
    - replace n with (S (n - 1)) by lia. apply below. lia. }
  assert (up : forall j, (j <= t)%nat -> eta (t + 1 - j) <= eta (t + 1)).
  { induction j as [| j ih]; intro hj; [rewrite Nat.sub_0_r; lra |].
    assert (c := proj2 (step_weak (t + 1 - S j) ltac:(lia)) (proj2 (count (t + 1 - S j)%nat ltac:(lia)) ltac:(lia))).
    replace (t + 1 - S j + 1)%nat with (t + 1 - j)%nat in c by lia. specialize (ih ltac:(lia)). lra. }
  assert (down : forall j, eta (t + 1 + j + 1) < eta (t + 1)).
  { induction j as [| j ih].
    - rewrite Nat.add_0_r. apply Rnot_le_lt. intro g. apply Rle_ge in g. apply step_weak in g; [| lia].
      apply (proj1 (count (t + 1)%nat ltac:(lia))) in g. lia.
    - apply Rlt_trans with (2 := ih). apply Rnot_le_lt. intro g. apply Rle_ge in g.
      replace (t + 1 + S j)%nat with (t + 1 + j + 1)%nat in g by lia. apply step_weak in g; [| lia].
      apply (proj1 (count (t + 1 + j + 1)%nat ltac:(lia))) in g. lia. }
  split; [exact count |]. split.
  - intros k hk. destruct (Nat.le_gt_cases k (t + 1)) as [l | g].
    + replace k with (t + 1 - (t + 1 - k))%nat by lia. apply up. lia.
    + left. replace k with (t + 1 + (k - t - 2) + 1)%nat by lia. apply down.
  - intros k hk tie. destruct (Nat.le_gt_cases k (t + 1)) as [l | g].
    + destruct (Nat.eq_dec k (t + 1)) as [-> | ne]; [now left | right].
      assert (lk := proj2 (count k hk) ltac:(lia)).
      assert (not_lt : ~ L k < e).
      { intro lt. apply (step_strict k hk) in lt. assert (u := up (t + 1 - (k + 1))%nat ltac:(lia)).
        replace (t + 1 - (t + 1 - (k + 1)))%nat with (k + 1)%nat in u by lia. lra. }
      assert (eq : L k = e) by lra. destruct (Nat.eq_dec k t) as [-> | ne']; [tauto | exfalso].
      assert (up1 := rises k (t - k) hk). replace (k + (t - k))%nat with t in up1 by lia.
      assert (le := proj2 (count t ltac:(lia)) ltac:(lia)). assert (up2 := rises (k + 1) (t - (k + 1)) ltac:(lia)).
      replace (k + 1 + (t - (k + 1)))%nat with t in up2 by lia.
      destruct (Req_dec m1 m2) as [em | nm].
      * assert (one := proj2 (b_best_elastic.b_best_elastic m1 m2 h1 h2 k hk) em). cbv beta zeta in one.
        unfold L, s in eq. lra.
      * assert (q := proj2 (b_grow.b_grow m1 m2 h1 h2 k hk) nm). cbv beta zeta in q. unfold L, s in *. lra.
    + exfalso. assert (d := down (k - t - 2)%nat). replace (t + 1 + (k - t - 2) + 1)%nat with k in d by lia. lra.
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
Proof. intros m1 m2 e h1 h2 he. exact (best_number_exists m1 m2 e h1 h2 he). Qed.

Theorem always_helps : forall m1 m2 n, m1 > 0 -> m2 > 0 -> (n >= 1)%nat ->
  let S := fun k : nat => Rpower m1 (1 / INR k) + Rpower m2 (1 / INR k) in
  0 < S (n + 1)%nat ^ (n + 1) / S n ^ n - 1 <= 1.
Proof.
  intros m1 m2 n h1 h2 hn. cbv beta zeta. assert (low := b_positive.b_positive m1 m2 h1 h2 n hn).
  assert (up := proj1 (b_grow_bounded.b_grow_bounded m1 m2 h1 h2 n hn)). cbv beta zeta in low, up.
  set (A := (Rpower m1 (1 / INR n) + Rpower m2 (1 / INR n)) ^ n) in *.
  set (B := (Rpower m1 (1 / INR (n + 1)) + Rpower m2 (1 / INR (n + 1))) ^ (n + 1)) in *.
  assert (a : 0 < A) by (unfold A; pos). replace (B / A - 1) with ((B - A) / A) by (field; lra). split.
  - apply Rdiv_lt_0_compat; lra.
  - apply Rmult_le_reg_r with A; [exact a |]. replace ((B - A) / A * A) with (B - A) by (field; lra). lra.
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
  destruct (proj1 (eq05_unique.eq05_unique _ _ (hm t) (hm (t + 1)%nat) _ (he t) _ _ _ _) (conj p q)) as [a b].
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
  assert (lp := linked_pos mu hm).
  induction t as [| t ih]; intro ht.
  - rewrite (proj1 (struck 0%nat ltac:(lia))), moving. unfold linked. rewrite !product_over_one.
    assert (a := hm 0%nat). assert (b := hm (0 + 1)%nat). field. lra.
  - rewrite (proj1 (struck (S t) ht)). replace (v (S t) (S t)) with (v (t + 1)%nat (t + 1)%nat) by (now replace (S t) with (t + 1)%nat by lia).
    rewrite ih by lia. unfold linked. rewrite !product_over_last by lia. cbv beta. fold (linked mu t).
    assert (a := hm (S t)). assert (b := hm (S t + 1)%nat). specialize (lp t). field. lra.
Qed.

Lemma share_of_front : v1 > 0 ->
  (mu (n + 1)%nat * v (n + 1)%nat (n + 1)%nat ^ 2 / 2) / (mu 0%nat * v1 ^ 2 / 2)
  = product_over 0 n (fun i => (1 + e i) ^ 2) * mu 0%nat * mu (n + 1)%nat * product_over 1 n mu ^ 2 / linked mu n ^ 2.
Proof.
  intro hv. rewrite front by lia. rewrite <- (product_over_square 0 n (fun i => 1 + e i)). rewrite (product_over_first n mu).
  assert (a := hm 0%nat). assert (l := linked_pos mu hm n). field. lra.
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
  rewrite (share_of_front n mu e v1 v hm he moving resting collision hv). exact (best_chain n mu e hm he).
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
    rewrite (proj1 (struck n mu (fun _ => e) v hm (fun _ => he) resting collision t ltac:(lia))), ih by lia.
    rewrite geometric by lia. assert (c := hm t). rewrite pow_add. assert (cx : 0 < mu t * x) by pos. field. repeat split; lra. }
  split; [| apply frontal; lia].
  intros i hi. rewrite (kept n mu (fun _ => e) v collision) by lia.
  rewrite (proj2 (struck n mu (fun _ => e) v hm (fun _ => he) resting collision i hi)), frontal by lia.
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
