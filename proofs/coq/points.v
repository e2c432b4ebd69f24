(** Negations: that a claim fails at a point. *)
From Carom Require Export rules.
From Carom Require Import bounds.
From Coq Require Import Lra Lia.
Open Scope R_scope.

(** A root of a fraction that is a fraction with small numbers, found by trying. *)
Lemma sqrt_is : forall a r, 0 <= r -> r * r = a -> sqrt a = r.
Proof. intros a r h e. subst. now apply sqrt_square. Qed.
Lemma cbrt_is : forall a r, 0 < r -> r * r * r = a -> cbrt a = r.
Proof.
  intros a r h e. subst. unfold cbrt. replace (r * r * r) with (Rpower r (INR 3)) by (rewrite Rpower_pow by exact h; cbn; ring).
  rewrite Rpower_mult. replace (INR 3 * (1 / 3)) with 1 by (cbn; lra). now apply Rpower_1.
Qed.
Ltac try_root is a p q := let r := constr:(IZR p / IZR q) in rewrite (is a r) in * by lra.
Ltac with_top is a q p := first
  [ try_root is a p q
  | lazymatch p with 20%Z => fail | _ => let s := eval compute in (p + 1)%Z in with_top is a q s end ].
Ltac with_bottom is a q := first
  [ with_top is a q 0%Z
  | lazymatch q with 12%Z => fail | _ => let s := eval compute in (q + 1)%Z in with_bottom is a s end ].
Ltac roots := repeat match goal with
  | |- context [sqrt ?a] => with_bottom sqrt_is a 1%Z
  | |- context [cbrt ?a] => with_bottom cbrt_is a 1%Z
  | _ : context [sqrt ?a] |- _ => with_bottom sqrt_is a 1%Z
  | _ : context [cbrt ?a] |- _ => with_bottom cbrt_is a 1%Z
  end.

(** A statement of numbers, by computing it. *)
Ltac numbers := cbn [pow Nat.add Nat.mul Nat.pow INR] in *; roots; lra.
Ltac holds_there := first
  [ bounds
  | lazymatch goal with
    | |- _ /\ _ => split; holds_there
    | |- _ <-> _ => split; holds_there
    | |- _ \/ _ => first [left; holds_there | right; holds_there]
    | |- ~ _ => let h := fresh in intro h; fails_there h
    | |- _ -> _ => let h := fresh in intro h; first [holds_there | exfalso; fails_there h]
    | _ => numbers
    end ]
with fails_there h := first
  [ refuted_by h
  | lazymatch type of h with
    | _ /\ _ => let a := fresh in let b := fresh in destruct h as [a b]; first [fails_there a | fails_there b]
    | ?A <-> ?B => let a := fresh in let b := fresh in destruct h as [a b]; first [fails_there a | fails_there b]
    | _ \/ _ => destruct h as [h | h]; fails_there h
    | ~ _ => apply h; holds_there
    | ?A -> ?B => let a := fresh in assert (a : A) by holds_there; let b := fresh in assert (b := h a); clear h; fails_there b
    | _ => exfalso; clear - h; numbers
    end ].
Ltac evaluated := holds_there.
Ltac computed := cbv beta zeta; intros; subst; repeat match goal with |- _ /\ _ => split end; holds_there.

(** A function given by its first values: what holds of all of them. *)
Ltac members_from k := first [solve [cbn; lra] | (destruct k as [| k]; [solve [cbn; lra] | members_from k])].
Ltac members := let k := fresh in intro k; members_from k.

(** Numbers put for variables. *)
Ltac plain := first [reflexivity | assumption | lra | lia | solve [repeat split; first [lra | lia]] | solve [members] | solve [cbn; lra]].
Ltac premises_at z := repeat match type of z with
  | (?A -> ?B) => let h := fresh in assert (h : A) by (first [plain | hyp]); specialize (z h); clear h end.
Ltac put z v := premises_at z; specialize (z v); cbv beta in z.

(** The statement [z], with the point put in, is what [w] denies. *)
Ltac contrary w z := cbv beta iota in w, z; repeat match type of w with _ /\ _ => let a := fresh in destruct w as [a w] end;
  first [exact (w z) | (cbn in w, z; exact (w z)) | (apply w; solve [intros; apply z; plain])].
