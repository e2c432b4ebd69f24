(** Numbers made of fractions and square and cube roots, between fractions that Coq computes: what decides their order. *)
From Carom Require Export rules.
From Coq Require Import QArith Qpower Qreals Lra Lia.
Open Scope R_scope.

(** * What a number is made of, and between which fractions it lies *)
Inductive ix := IN (z : Z) | IA (a b : ix) | IO (a : ix) | IM (a b : ix) | IV (a : ix) | IW (a : ix) (k : nat) | IS (a : ix) | IC (a : ix).
Fixpoint number_of (t : ix) : R :=
  match t with
  | IN z => IZR z | IA a b => number_of a + number_of b | IO a => - number_of a | IM a b => number_of a * number_of b
  | IV a => / number_of a | IW a k => number_of a ^ k | IS a => sqrt (number_of a) | IC a => cbrt (number_of a)
  end.
Definition between := option (Q * Q).
Definition inside (b : between) (x : R) : Prop := match b with Some (l, h) => Q2R l <= x <= Q2R h | None => True end.
Definition mul (x y : between) : between :=
  match x, y with
  | Some (a, b), Some (c, d) =>
      let pick l h := Some (Qred l, Qred h) in
      if Qle_bool 0 a then
        if Qle_bool 0 c then pick (a * c)%Q (b * d)%Q else if Qle_bool d 0 then pick (b * c)%Q (a * d)%Q else pick (b * c)%Q (b * d)%Q
      else if Qle_bool b 0 then
        if Qle_bool 0 c then pick (a * d)%Q (b * c)%Q else if Qle_bool d 0 then pick (b * d)%Q (a * c)%Q else pick (a * d)%Q (a * c)%Q
      else if Qle_bool 0 c then pick (a * d)%Q (b * d)%Q else if Qle_bool d 0 then pick (b * c)%Q (a * c)%Q else None
  | _, _ => None
  end.
(** The largest fraction of this denominator whose k-th power is at most q, by halving. *)
Fixpoint root_search (k : nat) (q : Q) (steps : nat) (low step : Z) : Z :=
  match steps with
  | O => low
  | S m => let next := (low + step)%Z in
      root_search k q m (if Qle_bool (Qpower (next # 1099511627776) (Z.of_nat k)) q then next else low) (step / 2)
  end.
Definition root_below (k : nat) (q : Q) : Q :=
  Qred (root_search k q 80 0 (2 ^ 79)%Z # 1099511627776).
Definition root (k : nat) (x : between) : between :=
  match x with
  | Some (a, b) =>
      let l := root_below k a in let h := (root_below k b + (1 # 1099511627776))%Q in
      if Qle_bool 0 l && Qle_bool (l ^ Z.of_nat k) a && Qle_bool b (h ^ Z.of_nat k) && Qle_bool (1 # 1099511627776) a && Qle_bool (1 # 1099511627776) h then Some (l, h) else None
  | None => None
  end.
Fixpoint raise (x : between) (k : nat) : between := match k with O => Some (1%Q, 1%Q) | S m => mul x (raise x m) end.
Fixpoint enclosure (t : ix) : between :=
  match t with
  | IN z => Some (inject_Z z, inject_Z z)
  | IA a b => match enclosure a, enclosure b with Some (l, h), Some (m, i) => Some (Qred (l + m), Qred (h + i)) | _, _ => None end
  | IO a => match enclosure a with Some (l, h) => Some (- h, - l)%Q | None => None end
  | IM a b => mul (enclosure a) (enclosure b)
  | IV a => match enclosure a with
            | Some (l, h) => if Qle_bool l 0 && Qle_bool 0 h then None else Some (/ h, / l)%Q
            | None => None end
  | IW a k => raise (enclosure a) k
  | IS a => root 2 (enclosure a)
  | IC a => root 3 (enclosure a)
  end.

Lemma q_le : forall a b, Qle_bool a b = true -> Q2R a <= Q2R b. Proof. intros a b h. apply Qle_Rle. now apply Qle_bool_iff. Qed.
Lemma q_gt : forall a b, Qle_bool a b = false -> Q2R b < Q2R a.
Proof. intros a b h. apply Qlt_Rlt. apply Qnot_le_lt. intro g. apply Qle_bool_iff in g. congruence. Qed.
Lemma q_0 : Q2R 0 = 0. Proof. unfold Q2R. cbn. lra. Qed.
Lemma q_red : forall a, Q2R (Qred a) = Q2R a. Proof. intro a. apply Qeq_eqR, Qred_correct. Qed.

Lemma mul_inside : forall x y u v, inside x u -> inside y v -> inside (mul x y) (u * v).
Proof.
  intros [[a b] |] [[c d] |] u v; cbn [inside mul]; try tauto. intros hu hv.
  repeat match goal with |- context [Qle_bool ?p ?q] => let e := fresh "e" in destruct (Qle_bool p q) eqn:e; [apply q_le in e | apply q_gt in e] end;
  cbn [inside]; try exact I; rewrite ?q_0 in *; rewrite ?q_red, ?Q2R_mult; split; nra.
Qed.
Lemma raise_inside : forall x u k, inside x u -> inside (raise x k) (u ^ k).
Proof. intros x u k h. induction k; [cbn; unfold Q2R; cbn; lra | cbn [raise pow]; now apply mul_inside]. Qed.
Lemma q_pow : forall a k, Q2R (a ^ Z.of_nat k) = Q2R a ^ k.
Proof.
  intros a k. induction k as [| k IH]; [cbn; unfold Q2R; cbn; lra |].
  rewrite Nat2Z.inj_succ, <- Z.add_1_r. destruct (Qeq_dec a 0) as [e | e].
  - rewrite Z.add_1_r, <- Nat2Z.inj_succ. rewrite <- tech_pow_Rmult.
    replace (Q2R a) with 0 by (rewrite (Qeq_eqR _ _ e); symmetry; apply q_0). rewrite Rmult_0_l, <- q_0. apply Qeq_eqR.
    rewrite e. apply Qpower_0. lia.
  - rewrite (Qeq_eqR _ _ (Qpower_plus _ _ _ e)), Q2R_mult, IH. cbn. rewrite Rmult_comm. reflexivity.
Qed.
Lemma root_inside : forall k x u v, (0 < k)%nat -> (0 < u -> 0 <= v /\ v ^ k = u) -> inside x u -> inside (root k x) v.
Proof.
  intros k [[a b] |] u v hk h; cbn [inside root]; [| tauto]. intro hu.
  match goal with |- context [if ?c then _ else _] => destruct c eqn:e end; [| exact I].
  repeat (apply andb_prop in e; let f := fresh in destruct e as [e f]; apply q_le in f). apply q_le in e. cbn [inside].
  rewrite q_pow in *. rewrite q_0 in *.
  assert (t : 0 < Q2R (1 # 1099511627776)) by (unfold Q2R; cbn; lra).
  destruct (h ltac:(lra)) as [hv <-].
  assert (p : forall y z, 0 <= y -> 0 <= z -> y ^ k <= z ^ k -> y <= z).
  { intros y z hy hz g. destruct (Rle_or_lt y z) as [w | w]; [exact w |]. exfalso.
    apply (rising_pow z y k hk hz hy) in w. lra. }
  split; (apply p; [lra | lra |]); lra.
Qed.
Lemma inv_below_0 : forall x y, x <= y -> y < 0 -> / y <= / x.
Proof.
  intros x y h hy. assert (e : forall z, z < 0 -> / z = - / - z) by (intros z hz; field; lra). rewrite (e x), (e y) by lra.
  apply Ropp_le_contravar, Rinv_le_contravar; lra.
Qed.
Theorem enclosed : forall t, inside (enclosure t) (number_of t).
Proof.
  induction t as [z | s IHs t IHt | t IH | s IHs t IHt | t IH | t IH k | t IH | t IH]; cbn [enclosure number_of].
  - unfold inside, inject_Z, Q2R. cbn. lra.
  - destruct (enclosure s) as [[l h] |], (enclosure t) as [[m i] |]; cbn [inside] in *; try exact I. rewrite !q_red, !Q2R_plus. lra.
  - destruct (enclosure t) as [[l h] |]; cbn [inside] in *; [| exact I]. rewrite !Q2R_opp. lra.
  - now apply mul_inside.
  - destruct (enclosure t) as [[l h] |]; cbn [inside] in *; [| exact I].
    destruct (Qle_bool l 0 && Qle_bool 0 h) eqn:e; [exact I |]. cbn [inside].
    assert (c : Q2R h < 0 \/ 0 < Q2R l).
    { apply andb_false_iff in e. destruct e as [e | e]; apply q_gt in e; rewrite q_0 in e; [now right | now left]. }
    assert (nz : forall q, Q2R q <> 0 -> ~ (q == 0)%Q) by (intros q n z; apply n; rewrite (Qeq_eqR _ _ z); apply q_0).
    rewrite !Q2R_inv by (apply nz; lra).
    destruct c as [c | c]; split.
    + apply inv_below_0; lra.
    + apply inv_below_0; lra.
    + apply Rinv_le_contravar; lra.
    + apply Rinv_le_contravar; lra.
  - now apply raise_inside.
  - apply (root_inside 2 _ (number_of t)); [lia | | exact IH]. intro h. split; [apply sqrt_pos | cbn; rewrite Rmult_1_r; apply sqrt_def; lra].
  - apply (root_inside 3 _ (number_of t)); [lia | | exact IH]. intro h. unfold cbrt. split; [left; apply exp_pos |].
    rewrite <- Rpower_pow by apply exp_pos. rewrite Rpower_mult. replace (1 / 3 * INR 3) with 1 by (cbn; lra). now apply Rpower_1.
Qed.
Lemma less : forall s t, match enclosure s, enclosure t with Some (_, h), Some (l, _) => negb (Qle_bool l h) | _, _ => false end = true ->
  number_of s < number_of t.
Proof.
  intros s t e. assert (hs := enclosed s). assert (ht := enclosed t).
  destruct (enclosure s) as [[a b] |], (enclosure t) as [[c d] |]; try discriminate. cbn [inside] in *.
  apply negb_true_iff, q_gt in e. lra.
Qed.
Ltac read_number e := lazymatch e with
  | ?a + ?b => let x := read_number a in let y := read_number b in constr:(IA x y)
  | ?a - ?b => let x := read_number a in let y := read_number b in constr:(IA x (IO y))
  | ?a * ?b => let x := read_number a in let y := read_number b in constr:(IM x y)
  | ?a / ?b => let x := read_number a in let y := read_number b in constr:(IM x (IV y))
  | - ?a => let x := read_number a in constr:(IO x)
  | / ?a => let x := read_number a in constr:(IV x)
  | ?a ^ ?k => let x := read_number a in constr:(IW x k)
  | sqrt ?a => let x := read_number a in constr:(IS x)
  | cbrt ?a => let x := read_number a in constr:(IC x)
  | IZR ?z => constr:(IN z)
  end.
Ltac bounds := lazymatch goal with
  | |- ?a < ?b => let x := read_number a in let y := read_number b in change (number_of x < number_of y); apply less; vm_compute; reflexivity
  | |- ?a > ?b => red; bounds
  | |- ?a <= ?b => left; bounds
  | |- ?a >= ?b => left; red; bounds
  | |- ?a <> ?b => first [apply Rlt_not_eq; bounds | apply Rgt_not_eq; red; bounds]
  end.
(** A hypothesis that bounds contradict. *)
Ltac refuted_by h := exfalso; let z := fresh in lazymatch type of h with
  | ?a < ?b => assert (z : b <= a) by bounds; exact (Rle_not_lt _ _ z h)
  | ?a > ?b => assert (z : a <= b) by bounds; exact (Rle_not_lt _ _ z h)
  | ?a <= ?b => assert (z : b < a) by bounds; exact (Rlt_not_le _ _ z h)
  | ?a >= ?b => assert (z : a < b) by bounds; exact (Rlt_not_ge _ _ z h)
  | ?a = ?b => assert (z : a <> b) by bounds; exact (z h)
  end.
