(** How the proofs begin: a statement's hypotheses named, its definitions put in place. *)

From Carom Require Import vocabulary weighted_mean.
From Carom Require Export statements.
From Coq Require Import Lra Lia.

Ltac in_place := repeat match goal with x := _ |- _ => subst x end; cbv beta in *.

Ltac start := red; intros; in_place.

(** For the statements that all expressions have values. *)
Ltac values := start; repeat split; intros; pos.

(** A quotient of positive numbers compared after clearing denominators. *)
Lemma quotient_le : forall a b c d, 0 < b -> 0 < d -> a * d <= c * b -> a / b <= c / d.
Proof.
  intros a b c d hb hd h. apply Rmult_le_reg_r with (b * d); [pos |].
  replace (a / b * (b * d)) with (a * d) by (field; lra). replace (c / d * (b * d)) with (c * b) by (field; lra).
  exact h.
Qed.

Lemma quotient_le_iff : forall a b c d, 0 < b -> 0 < d -> (a / b <= c / d <-> a * d <= c * b).
Proof.
  intros a b c d hb hd. split; [| now apply quotient_le]. intro h.
  replace (a * d) with (a / b * (b * d)) by (field; lra). replace (c * b) with (c / d * (b * d)) by (field; lra).
  apply Rmult_le_compat_r; [left; pos | exact h].
Qed.

Lemma quotient_lt_iff : forall a b c d, 0 < b -> 0 < d -> (a / b < c / d <-> a * d < c * b).
Proof.
  intros a b c d hb hd. split; intro h.
  - apply Rnot_le_lt. intro g. apply (quotient_le c d a b hd hb) in g. lra.
  - apply Rnot_le_lt. intro g. apply (quotient_le_iff c d a b hd hb) in g. lra.
Qed.

Lemma quotient_eq_iff : forall a b c d, 0 < b -> 0 < d -> (a / b = c / d <-> a * d = c * b).
Proof.
  intros a b c d hb hd. split; intro h.
  - replace (a * d) with (a / b * (b * d)) by (field; lra). rewrite h. field. lra.
  - apply Rmult_eq_reg_r with (b * d); [| pos].
    replace (a / b * (b * d)) with (a * d) by (field; lra). rewrite h. field. lra.
Qed.

(** Squares of non-negative numbers are ordered as the numbers are. *)
Lemma square_le_iff : forall a b, 0 <= a -> 0 <= b -> (a ^ 2 <= b ^ 2 <-> a <= b).
Proof.
  intros a b ha hb. split; intro h.
  - apply Rnot_lt_le. intro g. assert (b * b < a * a) by (apply Rmult_le_0_lt_compat; assumption). lra.
  - apply pow_incr. lra.
Qed.

(** A positive number by its sixth root: square and cube roots become powers. *)
Lemma sixth_root : forall m, m > 0 ->
  exists a, 0 < a /\ m = a ^ 6 /\ sqrt m = a ^ 3 /\ cbrt m = a ^ 2.
Proof.
  intros m hm. exists (Rpower m (1 / 6)).
  assert (ha : 0 < Rpower m (1 / 6)) by apply exp_pos.
  assert (p : forall k, Rpower m (1 / 6) ^ k = Rpower m (INR k / 6)).
  { intro k. rewrite <- Rpower_pow by exact ha. rewrite Rpower_mult. f_equal. field. }
  split; [exact ha |]. rewrite !p. cbn [INR]. repeat split.
  - replace ((1 + 1 + 1 + 1 + 1 + 1) / 6) with 1 by field. symmetry. now apply Rpower_1.
  - rewrite <- Rpower_sqrt by exact hm. f_equal. field.
  - unfold cbrt. f_equal. field.
Qed.

Lemma square_root : forall m, m > 0 -> exists a, 0 < a /\ m = a ^ 2 /\ sqrt m = a.
Proof.
  intros m hm. exists (sqrt m). assert (h := sqrt_lt_R0 m hm). repeat split; [exact h |].
  cbn. rewrite Rmult_1_r. symmetry. apply sqrt_sqrt. lra.
Qed.

Lemma quotient_one : forall a b, 0 < b -> (a / b = 1 <-> a = b).
Proof.
  intros a b hb. split; intro h.
  - replace a with (a / b * b) by (field; lra). rewrite h. ring.
  - rewrite h. field. lra.
Qed.

Lemma quotient_le_inv : forall a b c d, 0 < b -> 0 < d -> a / b <= c / d -> a * d <= c * b.
Proof. intros a b c d hb hd. apply (quotient_le_iff a b c d hb hd). Qed.
