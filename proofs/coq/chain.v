(** Sums and products over a chain, and the bound that no chain exceeds. *)

From Carom Require Import vocabulary weighted_mean.
From Coq Require Import Lra Lia.

(** ** Sums and products, term by term *)

Lemma sum_over_one : forall a f, sum_over a a f = f a.
Proof. intros. unfold sum_over. replace (a + 1 - a)%nat with 1%nat by lia. cbn. rewrite Nat.add_0_r. ring. Qed.

Lemma sum_over_last : forall a b f, (a <= S b)%nat -> sum_over a (S b) f = sum_over a b f + f (S b).
Proof.
  intros a b f h. unfold sum_over. replace (S b + 1 - a)%nat with (S (b + 1 - a)) by lia. cbn.
  replace (a + (b + 1 - a))%nat with (S b) by lia. reflexivity.
Qed.

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


Lemma product_over_ext : forall a b f g, (a <= b + 1)%nat -> (forall k, (a <= k <= b)%nat -> f k = g k) ->
  product_over a b f = product_over a b g.
Proof.
  intros a b f g hab h. unfold product_over. assert (c : forall d, (a + d <= b + 1)%nat ->
    product_terms f a d = product_terms g a d).
  { induction d as [| d ih]; intro hd; cbn; [reflexivity |]. rewrite ih by lia. rewrite h by lia. reflexivity. }
  apply c. lia.
Qed.

(** ** The tangent of a whole chain

    For any ratio r the bound of a link, multiplied over the chain, telescopes. *)

Definition linked (mu : nat -> R) (n : nat) : R := product_over 0 n (fun i => mu i + mu (i + 1)%nat).

Lemma linked_next : forall mu n, linked mu (S n) = linked mu n * (mu (S n) + mu (S n + 1)%nat).
Proof. intros. unfold linked. now rewrite product_over_last by lia. Qed.

Lemma linked_pos : forall mu n, (forall k, 0 < mu k) -> 0 < linked mu n.
Proof. intros mu n h. apply product_over_pos. intro k. apply Rplus_lt_0_compat; apply h. Qed.

(** A step of the induction: x, y are what stands on both sides so far. *)
Lemma step_weak : forall x y c a b A B Rp K, 0 < A -> 0 < B -> 0 < Rp -> 0 < x -> 0 < y -> 0 < c -> 0 < K ->
  x * c >= y * A -> (a + b) * A * Rp >= K * B -> 0 < a + b ->
  x * (a + b) * (c * Rp) >= y * K * B.
Proof.
  intros x y c a b A B Rp K hA hB hR hx hy hc hK h1 h2 hab.
  apply Rle_ge, Rmult_le_reg_r with A; [exact hA |].
  apply Rge_le in h1. apply Rge_le in h2.
  assert (p : y * A * (K * B) <= x * c * ((a + b) * A * Rp)).
  { apply Rmult_le_compat; try lra; left; pos. }
  lra.
Qed.

Lemma step_strict : forall x y c a b A B Rp K, 0 < A -> 0 < B -> 0 < Rp -> 0 < x -> 0 < y -> 0 < c -> 0 < K ->
  x * c >= y * A -> (a + b) * A * Rp >= K * B -> 0 < a + b ->
  (x * c > y * A \/ (a + b) * A * Rp > K * B) ->
  x * (a + b) * (c * Rp) > y * K * B.
Proof.
  intros x y c a b A B Rp K hA hB hR hx hy hc hK h1 h2 hab ho.
  apply Rlt_gt, Rmult_lt_reg_r with A; [exact hA |].
  assert (q1 : 0 < y * A) by pos. assert (q2 : 0 < K * B) by pos.
  assert (q3 : 0 < x * c) by pos. assert (q4 : 0 < (a + b) * A * Rp) by pos.
  assert (p : y * A * (K * B) < x * c * ((a + b) * A * Rp)).
  { destruct ho as [h | h].
    - apply Rlt_le_trans with (x * c * (K * B)); [apply Rmult_lt_compat_r; lra | apply Rmult_le_compat_l; lra].
    - apply Rle_lt_trans with (x * c * (K * B)); [apply Rmult_le_compat_r; lra | apply Rmult_lt_compat_l; lra]. }
  lra.
Qed.

Section Chain.
Variables (mu : nat -> R) (r p : R).
Hypothesis mu_pos : forall k, mu k > 0.
Hypothesis r_pos : r > 0.
Hypothesis p_def : p = r / (1 + r).

Lemma chain_tangent : forall n,
  linked mu n * (Rpower (mu 0%nat) p * Rpower r p ^ (n + 1))
  >= product_over 0 n mu * (1 + r) ^ (n + 1) * Rpower (mu (n + 1)%nat) p.
Proof.
  induction n as [| n ih].
  - unfold linked. rewrite !product_over_one. cbn. rewrite !Rmult_1_r.
    assert (l := link (mu 0%nat) (mu 1%nat) r p (mu_pos 0%nat) (mu_pos 1%nat) r_pos p_def). lra.
  - rewrite linked_next, product_over_last by lia. replace (S n + 1)%nat with (S (n + 1)) by lia.
    rewrite <- !tech_pow_Rmult. replace (S n) with (n + 1)%nat by lia.
    replace (S (n + 1)) with (n + 1 + 1)%nat by lia.
    assert (l := link (mu (n + 1)%nat) (mu (n + 1 + 1)%nat) r p (mu_pos _) (mu_pos _) r_pos p_def).
    assert (s := step_weak (linked mu n) (product_over 0 n mu * (1 + r) ^ (n + 1))
      (Rpower (mu 0%nat) p * Rpower r p ^ (n + 1)) (mu (n + 1)%nat) (mu (n + 1 + 1)%nat)
      (Rpower (mu (n + 1)%nat) p) (Rpower (mu (n + 1 + 1)%nat) p) (Rpower r p) (mu (n + 1)%nat * (1 + r))).
    assert (hp : 0 < product_over 0 n mu) by (apply product_over_pos; intro; apply mu_pos).
    assert (hl : 0 < linked mu n) by (apply linked_pos; intro; apply mu_pos).
    assert (m0 := mu_pos (n + 1)). assert (m1 := mu_pos (n + 1 + 1)).
    repeat (lapply s; [clear s; intro s | first [exact ih | exact l | pos]]). lra.
Qed.

Lemma chain_tangent_strict : forall n i, (i <= n)%nat -> mu (i + 1)%nat <> mu i * r ->
  linked mu n * (Rpower (mu 0%nat) p * Rpower r p ^ (n + 1))
  > product_over 0 n mu * (1 + r) ^ (n + 1) * Rpower (mu (n + 1)%nat) p.
Proof.
  induction n as [| n ih]; intros i hi hd.
  - replace i with 0%nat in hd by lia. unfold linked. rewrite !product_over_one. cbn. rewrite !Rmult_1_r.
    assert (l := link_strict (mu 0%nat) (mu 1%nat) r p (mu_pos 0%nat) (mu_pos 1%nat) r_pos p_def hd). lra.
  - assert (weak := chain_tangent n).
    rewrite linked_next, product_over_last by lia. replace (S n + 1)%nat with (S (n + 1)) by lia.
    rewrite <- !tech_pow_Rmult. replace (S n) with (n + 1)%nat by lia.
    replace (S (n + 1)) with (n + 1 + 1)%nat by lia.
    assert (l := link (mu (n + 1)%nat) (mu (n + 1 + 1)%nat) r p (mu_pos _) (mu_pos _) r_pos p_def).
    assert (s := step_strict (linked mu n) (product_over 0 n mu * (1 + r) ^ (n + 1))
      (Rpower (mu 0%nat) p * Rpower r p ^ (n + 1)) (mu (n + 1)%nat) (mu (n + 1 + 1)%nat)
      (Rpower (mu (n + 1)%nat) p) (Rpower (mu (n + 1 + 1)%nat) p) (Rpower r p) (mu (n + 1)%nat * (1 + r))).
    assert (hp : 0 < product_over 0 n mu) by (apply product_over_pos; intro; apply mu_pos).
    assert (hl : 0 < linked mu n) by (apply linked_pos; intro; apply mu_pos).
    assert (m0 := mu_pos (n + 1)). assert (m1 := mu_pos (n + 1 + 1)).
    assert (some : linked mu n * (Rpower (mu 0%nat) p * Rpower r p ^ (n + 1))
        > product_over 0 n mu * (1 + r) ^ (n + 1) * Rpower (mu (n + 1)%nat) p
      \/ (mu (n + 1)%nat + mu (n + 1 + 1)%nat) * Rpower (mu (n + 1)%nat) p * Rpower r p
        > mu (n + 1)%nat * (1 + r) * Rpower (mu (n + 1 + 1)%nat) p).
    { destruct (Nat.eq_dec i (n + 1)) as [-> | ne].
      - right. apply link_strict; auto.
      - left. apply (ih i); [lia | exact hd]. }
    repeat (lapply s; [clear s; intro s | first [exact weak | exact l | exact some | pos]]). lra.
Qed.

End Chain.

(** ** The geometric chain is the best *)

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

(** The sum of the two n-th roots, as a multiple of the first. *)
Lemma root_sum : forall a b y, a > 0 -> b > 0 -> Rpower a y + Rpower b y = Rpower a y * (1 + Rpower (b / a) y).
Proof. intros. rewrite root_quotient by assumption. field. pos. Qed.

Section Global.
Variables (mu : nat -> R) (n : nat).
Hypothesis mu_pos : forall k, mu k > 0.

Let N := (n + 1)%nat.
Let r := Rpower (mu N / mu 0%nat) (1 / INR N).

Lemma ratio_pos : r > 0.
Proof. unfold r. pos. Qed.

Lemma ratio_power : r ^ N = mu N / mu 0%nat.
Proof.
  assert (h0 := mu_pos 0). assert (h1 := mu_pos N).
  unfold r. apply root_power; [pos | unfold N; lia].
Qed.

Lemma ends_cancel : forall p, Rpower (mu 0%nat) p * Rpower r p ^ N = Rpower (mu N) p.
Proof.
  intro p. assert (h0 := mu_pos 0). assert (h1 := mu_pos N). assert (hr := ratio_pos).
  rewrite <- Rpower_pow by pos. rewrite Rpower_mult, (Rmult_comm p), <- Rpower_mult.
  rewrite Rpower_pow by exact hr. rewrite ratio_power. rewrite Rpower_mult_distr; [| pos | pos].
  f_equal. field. lra.
Qed.

Lemma best_sum : mu 0%nat * (1 + r) ^ N = (Rpower (mu 0%nat) (1 / INR N) + Rpower (mu N) (1 / INR N)) ^ N.
Proof.
  assert (h0 := mu_pos 0). assert (h1 := mu_pos N).
  rewrite root_sum by assumption. fold r. rewrite Rpow_mult_distr. rewrite root_power; [reflexivity | exact h0 |].
  unfold N; lia.
Qed.

Lemma chain_bound :
  linked mu n >= product_over 1 n mu * (Rpower (mu 0%nat) (1 / INR N) + Rpower (mu N) (1 / INR N)) ^ N.
Proof.
  assert (h := chain_tangent mu r (r / (1 + r)) mu_pos ratio_pos eq_refl n).
  rewrite <- best_sum. fold N in h. rewrite ends_cancel, product_over_first in h.
  apply Rle_ge, Rmult_le_reg_r with (Rpower (mu N) (r / (1 + r))); [pos |]. lra.
Qed.

Lemma chain_bound_strict : forall i, (i <= n)%nat -> mu (i + 1)%nat <> mu i * r ->
  linked mu n > product_over 1 n mu * (Rpower (mu 0%nat) (1 / INR N) + Rpower (mu N) (1 / INR N)) ^ N.
Proof.
  intros i hi hd.
  assert (h := chain_tangent_strict mu r (r / (1 + r)) mu_pos ratio_pos eq_refl n i hi hd).
  rewrite <- best_sum. fold N in h. rewrite ends_cancel, product_over_first in h.
  apply Rlt_gt, Rmult_lt_reg_r with (Rpower (mu N) (r / (1 + r))); [pos |]. lra.
Qed.

Lemma chain_attained : (forall i, (i <= n)%nat -> mu (i + 1)%nat = mu i * r) ->
  linked mu n = product_over 1 n mu * (Rpower (mu 0%nat) (1 / INR N) + Rpower (mu N) (1 / INR N)) ^ N.
Proof.
  intro h. rewrite <- best_sum.
  replace (product_over 1 n mu * (mu 0%nat * (1 + r) ^ N)) with (product_over 0 n mu * (1 + r) ^ N)
    by (rewrite product_over_first; ring).
  unfold N. clear -h. assert (g : forall k, (k <= n)%nat -> linked mu k = product_over 0 k mu * (1 + r) ^ (k + 1)).
  { induction k as [| k ih]; intro hk.
    - unfold linked. rewrite !product_over_one, (h 0%nat) by lia. generalize r. intro q. simpl. ring.
    - rewrite linked_next, product_over_last, ih by lia. replace (S k + 1)%nat with (S (k + 1)) by lia.
      rewrite <- tech_pow_Rmult. replace (S (k + 1)) with (S k + 1)%nat by lia. rewrite (h (S k)) by lia. ring. }
  apply g. lia.
Qed.

(** All masses are those of (21) as soon as each is r times the one before it. *)
Lemma geometric_masses : (forall i, (i <= n)%nat -> mu (i + 1)%nat = mu i * r) <->
  (forall i, (i <= n + 1)%nat ->
    mu i = Rpower (mu 0%nat) ((INR N - INR i) / INR N) * Rpower (mu N) (INR i / INR N)).
Proof.
  assert (h0 := mu_pos 0). assert (h1 := mu_pos N). assert (hN : 0 < INR N) by (apply INR_pos; unfold N; lia).
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

End Global.
