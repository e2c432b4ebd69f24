(** Second theorems: that every expression of a claim has a value. *)
From Carom Require Export rules.
From Coq Require Import Lra Lia.
Open Scope R_scope.

(** Positive by its form: made of what is positive, and of natural numbers, without a minus sign. *)
Ltac by_form := first
  [ assumption
  | lazymatch goal with
    | |- 0 < INR _ => first [apply lt_0_INR; lia | apply Rlt_le_trans with 1; [exact Rlt_0_1 | apply (le_INR 1); lia]]
    | |- 0 < _ * _ => apply Rmult_lt_0_compat; by_form
    | |- 0 < _ / _ => apply Rdiv_lt_0_compat; by_form
    | |- 0 < / _ => apply Rinv_0_lt_compat; by_form
    | |- 0 < _ ^ _ => apply pow_lt; by_form
    | |- 0 < exp _ => apply exp_pos
    | |- 0 < Rpower _ _ => apply exp_pos
    | |- 0 < cbrt _ => apply exp_pos
    | |- 0 < cosh _ => apply cosh_pos
    | |- 0 < sqrt _ => apply sqrt_lt_R0; by_form
    | |- 0 < INR _ + _ => first [apply Rplus_le_lt_0_compat; [apply pos_INR | by_form] | apply Rplus_lt_le_0_compat; [by_form | apply pos_INR]]
    | |- 0 < _ + INR _ => apply Rplus_lt_le_0_compat; [by_form | apply pos_INR]
    | |- 0 < _ + _ => apply Rplus_lt_0_compat; by_form
    | |- 0 < IZR _ => now apply IZR_lt
    end
  | match goal with H : forall _ : nat, _ |- 0 < _ => apply H end
  | lra ].
Ltac need := first
  [ assumption
  | lazymatch goal with
    | |- _ <> 0 => apply Rgt_not_eq; red; by_form
    | |- _ > 0 => red; by_form
    | |- 0 <= _ => apply Rlt_le; by_form
    | |- _ \/ _ => first [left; apply Rgt_not_eq; red; by_form | right; apply Rlt_le; by_form]
    | |- forall _, _ => intro; need
    end ].

(** That a derivative is there, from what its parts need. *)
Ltac smooth := first
  [ (auto_derive; repeat split; first [exact I | need | nz1])
  | (unroot_all; auto_derive; repeat split; first [exact I | pos | solve [apply Rgt_not_eq; red; pos] | need | nz1]) ].
Lemma second_is_there : forall (f g : R -> R) x, 0 < x ->
  (forall y, 0 < y -> is_derive f y (g y)) -> ex_derive g x -> ex_derive_n f 2 x.
Proof.
  intros f g x hx h hg. cbn. apply (ex_derive_ext_loc g); [| exact hg].
  exists (mkposreal x hx). intros y hy. symmetry. apply is_derive_unique, h.
  unfold ball in hy. cbn in hy. unfold AbsRing_ball, abs, minus, plus, opp in hy. cbn in hy. apply Rabs_def2 in hy. lra.
Qed.
Ltac smooth_twice := eapply second_is_there; [need |
  (let y := fresh in let h := fresh in intros y h; auto_derive; [repeat split; first [exact I | need | nz1] | reflexivity]) | smooth].

(** What a claim's expressions need, one after the other: by its form, or from the fact that says the rest. *)
Ltac valued_by z := first
  [ exact z
  | lazymatch goal with
    | |- _ /\ _ => split; [valued_by z | valued_by z]
    | |- ex_derive _ _ => smooth
    | |- ex_derive_n _ 2 _ => smooth_twice
    | _ => first [need | hyp | finish z]
    end ].
Ltac valued z := cbv beta zeta; first [exact z | (let all := fresh in assert (all := z); apart_all; valued_by z)].
