(** What the generated proofs rest on: for each rule of the kernel its lemmas and tactics.

rule suppose: intro
rule let: intro
rule logic: logic
rule instance: give, premises, same
rule induction: nat_ind1, nat_from
rule existence: existence
rule witness: exists
rule extremum: finish
rule combination: by_sign, note_sign, product_corner, even_power, bounded_by, sine_arc, cosine_arc, divided, matrices, derive
rule name: named
rule power: by_logarithms, pw
rule monotone: rise_pow, rise_rpower, rise_sqrt, rise_cbrt, raised
rule unfold: product_last, product_first, sum_last, sum_first, product_empty, sum_empty, member
rule mean: mean_weak, mean_strict
rule tangent: tangent_weak, tangent_strict
rule circle: unit_circle, within_one, below_the_argument, below_the_tangent, multiple
rule arc: arcs_rise, arcsine_is, arctangent_is, of_arctangent, of_arcsine, slopes_of_arcs
rule slope: slope, slope_between, smooth_on, slope_integral, differentiable, slope_sign, sloped
rule intermediate: intermediate, smooth_on, differentiable
rule limit: lim_inv, lim_seq_inv
rule squeeze: squeeze_lim, squeeze_seq
rule along: along_lim, along_seq
rule eventually: eventually_lim, eventually_seq
rule termwise: sum_ext2, product_ext2, sum_le2, termwise
rule integer: whole_step, is_whole
rule evaluate: evaluated *)
From Carom Require Export vocabulary.
From Coq Require Export Lra Lia List ZArith Bool.
Import ListNotations.
Open Scope R_scope.

(** * Which of negative, zero, positive a number may be *)
Record sg := S3 { neg : bool; zer : bool; pos : bool }.
Definition holds (s : sg) (x : R) : Prop :=
  (x < 0 -> neg s = true) /\ (x = 0 -> zer s = true) /\ (0 < x -> pos s = true).

Definition within (s t : sg) : bool :=
  implb (neg s) (neg t) && implb (zer s) (zer t) && implb (pos s) (pos t).
Definition apart (s t : sg) : bool :=
  negb (neg s && neg t) && negb (zer s && zer t) && negb (pos s && pos t).
Definition meet (s t : sg) : sg := S3 (neg s && neg t) (zer s && zer t) (pos s && pos t).
Definition times (s t : sg) : sg :=
  S3 (neg s && pos t || pos s && neg t) (zer s && (neg t || zer t || pos t) || zer t && (neg s || zer s || pos s))
     (neg s && neg t || pos s && pos t).
Definition plus (s t : sg) : sg :=
  S3 (neg s && (neg t || zer t || pos t) || neg t && (zer s || pos s))
     (zer s && zer t || neg s && pos t || pos s && neg t)
     (pos s && (neg t || zer t || pos t) || pos t && (zer s || neg s)).
Definition power (s : sg) (k : nat) : sg :=
  match k with O => S3 false false true
  | _ => if Nat.even k then S3 false (zer s) (neg s || pos s) else s end.
Definition number (z : Z) : sg :=
  match z with Z0 => S3 false true false | Zpos _ => S3 false false true | Zneg _ => S3 true false false end.

Inductive sx := SA (i : nat) | SN (n : Z) (d : positive) | SM (a b : sx) | SP (a b : sx) | SW (a : sx) (k : nat) | SI (a : sx).

Fixpoint ev (env : list R) (t : sx) : R :=
  match t with
  | SA i => nth i env 0
  | SN n xH => IZR n
  | SN n d => IZR n / IZR (Zpos d)
  | SM a b => ev env a * ev env b
  | SP a b => ev env a + ev env b
  | SW a k => ev env a ^ k
  | SI a => / ev env a
  end.

Fixpoint sgn (se : list sg) (t : sx) : sg :=
  match t with
  | SA i => nth i se (S3 true true true)
  | SN n _ => number n
  | SM a b => times (sgn se a) (sgn se b)
  | SP a b => plus (sgn se a) (sgn se b)
  | SW a k => power (sgn se a) k
  | SI a => sgn se a
  end.

Fixpoint ok (env : list R) (se : list sg) : Prop :=
  match env, se with
  | x :: e, s :: t => holds s x /\ ok e t
  | nil, nil => True
  | _, _ => False
  end.

Ltac bools := repeat match goal with b : bool |- _ => destruct b end; cbn in *; try tauto; try lra; try congruence.

Lemma three : forall x, x < 0 \/ x = 0 \/ 0 < x. Proof. intro. lra. Qed.

Lemma holds_times : forall s t x y, holds s x -> holds t y -> holds (times s t) (x * y).
Proof.
  intros [a b c] [d e f] x y (h1 & h2 & h3) (k1 & k2 & k3). unfold holds, times. cbn in *.
  destruct (three x) as [hx | [hx | hx]]; destruct (three y) as [hy | [hy | hy]].
  all: try (assert (0 < x * y) by nra). all: try (assert (x * y < 0) by nra). all: try (assert (x * y = 0) by nra).
  all: repeat split; intro; try (exfalso; lra).
  all: try rewrite (h1 hx); try rewrite (h2 hx); try rewrite (h3 hx); try rewrite (k1 hy); try rewrite (k2 hy); try rewrite (k3 hy).
  all: clear; bools.
Qed.

Lemma holds_plus : forall s t x y, holds s x -> holds t y -> holds (plus s t) (x + y).
Proof.
  intros [a b c] [d e f] x y (h1 & h2 & h3) (k1 & k2 & k3). unfold holds, plus. cbn in *.
  destruct (three x) as [hx | [hx | hx]]; destruct (three y) as [hy | [hy | hy]].
  all: try rewrite (h1 hx); try rewrite (h2 hx); try rewrite (h3 hx); try rewrite (k1 hy); try rewrite (k2 hy); try rewrite (k3 hy).
  all: repeat split; intro; try (exfalso; lra); clear; bools.
Qed.

Lemma even_pow_pos : forall x k, x <> 0 -> Nat.even k = true -> 0 < x ^ k.
Proof.
  intros x k hx hk. apply Nat.even_spec in hk. destruct hk as [m ->]. rewrite pow_mult.
  apply pow_lt. nra.
Qed.

Lemma holds_power : forall s x k, holds s x -> holds (power s k) (x ^ k).
Proof.
  intros [a b c] x k (h1 & h2 & h3). destruct k as [| k]. { cbn. split; [| split]; cbn; intro; first [reflexivity | exfalso; lra]. }
  unfold power. cbn in h1, h2, h3. destruct (Nat.even (S k)) eqn:p.
  - destruct (three x) as [hx | [hx | hx]].
    + assert (0 < x ^ S k) by (apply even_pow_pos; [lra | exact p]). rewrite (h1 hx).
      split; [| split]; cbn [neg zer pos]; intro; first [reflexivity | exfalso; lra].
    + assert (x ^ S k = 0) by (rewrite hx; apply pow_i; lia). rewrite (h2 hx).
      split; [| split]; cbn [neg zer pos]; intro; first [reflexivity | exfalso; lra].
    + assert (0 < x ^ S k) by (apply even_pow_pos; [lra | exact p]). rewrite (h3 hx).
      split; [| split]; cbn [neg zer pos]; intro; first [apply orb_true_r | exfalso; lra].
  - assert (q : Nat.even k = true).
    { rewrite Nat.even_succ in p. rewrite <- Nat.negb_odd. rewrite p. reflexivity. }
    destruct (three x) as [hx | [hx | hx]].
    + assert (0 < x ^ k) by (apply even_pow_pos; [lra | exact q]).
      split; [| split]; cbn [neg zer pos pow]; intro; first [now auto | exfalso; nra].
    + split; [| split]; cbn [neg zer pos pow]; intro; first [now auto | exfalso; nra].
    + assert (0 < x ^ k) by (apply even_pow_pos; [lra | exact q]).
      split; [| split]; cbn [neg zer pos pow]; intro; first [now auto | exfalso; nra].
Qed.

Lemma holds_inv : forall s x, holds s x -> holds s (/ x).
Proof.
  intros s x (h1 & h2 & h3). destruct (three x) as [hx | [hx | hx]].
  - assert (/ x < 0) by (now apply Rinv_lt_0_compat). split; [| split]; intro; first [now auto | exfalso; lra].
  - rewrite hx. rewrite Rinv_0. split; [| split]; intro; first [now auto | exfalso; lra].
  - assert (0 < / x) by (now apply Rinv_0_lt_compat). split; [| split]; intro; first [now auto | exfalso; lra].
Qed.

Lemma holds_number : forall n d, holds (number n) (ev nil (SN n d)).
Proof.
  intros n d. assert (hd : 0 < / IZR (Zpos d)) by (apply Rinv_0_lt_compat, IZR_lt; lia).
  assert (h : exists x, 0 < x /\ ev nil (SN n d) = IZR n * x).
  { destruct d; [exists (/ IZR (Zpos d~1)) | exists (/ IZR (Zpos d~0)) | exists 1]; (split; [first [exact hd | lra] | cbn [ev]; unfold Rdiv; ring]). }
  destruct h as (x & hx & ->). destruct n; cbn [number].
  - split; [| split]; cbn; intro; first [reflexivity | exfalso; lra].
  - assert (0 < IZR (Zpos p)) by (apply IZR_lt; lia). split; [| split]; cbn [neg zer pos]; intro; first [reflexivity | exfalso; nra].
  - assert (IZR (Zneg p) < 0) by (apply IZR_lt; lia). split; [| split]; cbn [neg zer pos]; intro; first [reflexivity | exfalso; nra].
Qed.

Lemma holds_any : forall x, holds (S3 true true true) x.
Proof. intro. repeat split. Qed.

Lemma nth_holds : forall env se i, ok env se -> holds (nth i se (S3 true true true)) (nth i env 0).
Proof.
  induction env as [| x env IH]; intros [| s se] i h; cbn in h; try tauto.
  - destruct i; apply holds_any.
  - destruct i; cbn; [apply h | apply IH, h].
Qed.

Theorem sgn_sound : forall env se t, ok env se -> holds (sgn se t) (ev env t).
Proof.
  intros env se t h. induction t.
  - apply nth_holds, h.
  - apply holds_number.
  - now apply holds_times.
  - now apply holds_plus.
  - now apply holds_power.
  - now apply holds_inv.
Qed.

Lemma weaken : forall s t x, within s t = true -> holds s x -> holds t x.
Proof.
  intros [a b c] [d e f] x w (h1 & h2 & h3). unfold within in w. cbn in *. repeat split; intro h; cbn.
  - rewrite (h1 h) in w. clear - w. bools.
  - rewrite (h2 h) in w. clear - w. bools.
  - rewrite (h3 h) in w. clear - w. bools.
Qed.

Definition LT := S3 true false false.
Definition LE := S3 true true false.
Definition GT := S3 false false true.
Definition GE := S3 false true true.
Definition EQ := S3 false true false.
Definition NE := S3 true false true.

Lemma by_sign : forall env se t s d, ok env se -> d = ev env t -> within (sgn se t) s = true -> holds s d.
Proof. intros env se t s d h -> w. apply (weaken _ _ _ w), sgn_sound, h. Qed.

Lemma to_lt : forall a b, holds LT (a - b) -> a < b.
Proof. intros a b (h1 & h2 & h3). cbn in *. destruct (three (a - b)) as [h | [h | h]]; [lra | discriminate (h2 h) | discriminate (h3 h)]. Qed.
Lemma to_le : forall a b, holds LE (a - b) -> a <= b.
Proof. intros a b (h1 & h2 & h3). cbn in *. destruct (three (a - b)) as [h | [h | h]]; [lra | lra | discriminate (h3 h)]. Qed.
Lemma to_gt : forall a b, holds GT (a - b) -> a > b.
Proof. intros a b (h1 & h2 & h3). cbn in *. destruct (three (a - b)) as [h | [h | h]]; [discriminate (h1 h) | discriminate (h2 h) | lra]. Qed.
Lemma to_ge : forall a b, holds GE (a - b) -> a >= b.
Proof. intros a b (h1 & h2 & h3). cbn in *. destruct (three (a - b)) as [h | [h | h]]; [discriminate (h1 h) | lra | lra]. Qed.
Lemma to_eq : forall a b, holds EQ (a - b) -> a = b.
Proof. intros a b (h1 & h2 & h3). cbn in *. destruct (three (a - b)) as [h | [h | h]]; [discriminate (h1 h) | lra | discriminate (h3 h)]. Qed.
Lemma to_ne : forall a b, holds NE (a - b) -> a <> b.
Proof. intros a b (h1 & h2 & h3) e. cbn in *. assert (h : a - b = 0) by lra. discriminate (h2 h). Qed.
Lemma to_nz : forall a, holds NE a -> a <> 0.
Proof. intros a (h1 & h2 & h3) e. cbn in *. discriminate (h2 e). Qed.
Lemma to_pos : forall a, holds GT a -> 0 < a.
Proof. intros a (h1 & h2 & h3). cbn in *. destruct (three a) as [h | [h | h]]; [discriminate (h1 h) | discriminate (h2 h) | exact h]. Qed.
Ltac from := intros; repeat split; cbn; intros; try reflexivity; exfalso; lra.
Lemma of_lt : forall a b, a < b -> holds LT (a - b). Proof. from. Qed.
Lemma of_le : forall a b, a <= b -> holds LE (a - b). Proof. from. Qed.
Lemma of_gt : forall a b, a > b -> holds GT (a - b). Proof. from. Qed.
Lemma of_ge : forall a b, a >= b -> holds GE (a - b). Proof. from. Qed.
Lemma of_eq : forall a b, a = b -> holds EQ (a - b). Proof. from. Qed.
Lemma of_ne : forall a b, a <> b -> holds NE (a - b). Proof. intros a b h. repeat split; cbn; intros; try reflexivity. exfalso; apply h; lra. Qed.
Lemma of_nz : forall a, a <> 0 -> holds NE a. Proof. intros a h. repeat split; cbn; intros; try reflexivity. exfalso; apply h; lra. Qed.
Lemma of_pos : forall a, 0 < a -> holds GT a. Proof. from. Qed.
Lemma of_nat : forall n : nat, holds GE (INR n). Proof. intro n. assert (h := pos_INR n). from. Qed.
Lemma both : forall s t x, holds s x -> holds t x -> holds (meet s t) x.
Proof. intros [a b c] [d e f] x (h1 & h2 & h3) (k1 & k2 & k3). repeat split; intro h; cbn in *;
 [rewrite (h1 h), (k1 h) | rewrite (h2 h), (k2 h) | rewrite (h3 h), (k3 h)]; reflexivity. Qed.


(** Entry 0 is the factor whose sign is open: it has those with which the product may have the known signs. *)
Lemma note_sign : forall p env se t d known s, ok env se -> d = ev (p :: env) t -> holds known d ->
  (neg s || apart (sgn (LT :: se) t) known) && (zer s || apart (sgn (EQ :: se) t) known)
  && (pos s || apart (sgn (GT :: se) t) known) = true -> holds s p.
Proof.
  intros p env se t d known s h e k c.
  apply andb_prop in c. destruct c as [c c3]. apply andb_prop in c. destruct c as [c1 c2].
  assert (q : forall u, holds u p -> apart (sgn (u :: se) t) known = true -> False).
  { intros u hu a. assert (g : holds (sgn (u :: se) t) d) by (rewrite e; apply sgn_sound; split; assumption).
    clear - g k a. destruct (sgn (u :: se) t) as [x y z], known as [x' y' z']. destruct g as (g1 & g2 & g3), k as (k1 & k2 & k3).
    unfold apart in a. cbn in *. destruct (three d) as [i | [i | i]].
    - rewrite (g1 i), (k1 i) in a. discriminate.
    - rewrite (g2 i), (k2 i) in a. clear - a. bools.
    - rewrite (g3 i), (k3 i) in a. clear - a. bools. }
  repeat split; intro h'.
  - destruct (neg s); [reflexivity |]. exfalso. apply (q LT); [| exact c1]. clear - h'. repeat split; cbn; intros; try reflexivity; exfalso; lra.
  - destruct (zer s); [reflexivity |]. exfalso. apply (q EQ); [| exact c2]. clear - h'. repeat split; cbn; intros; try reflexivity; exfalso; lra.
  - destruct (pos s); [reflexivity |]. exfalso. apply (q GT); [| exact c3]. clear - h'. repeat split; cbn; intros; try reflexivity; exfalso; lra.
Qed.

(** * Products of powers: each factor with its exponent and its logarithm *)
Fixpoint dbl (n : nat) : nat := match n with O => O | S m => S (S (dbl m)) end.
Fixpoint pnat (p : positive) : nat := match p with xH => 1%nat | xO q => dbl (pnat q) | xI q => S (dbl (pnat q)) end.
Lemma pnat_ok : forall p, pnat p = Pos.to_nat p.
Proof.
  assert (d : forall n, dbl n = (2 * n)%nat) by (induction n; cbn; [reflexivity | rewrite IHn; lia]).
  induction p; cbn [pnat]; rewrite ?d, ?IHp; lia.
Qed.
Definition zpow (x : R) (k : Z) : R := match k with Z0 => 1 | Zpos n => x ^ pnat n | Zneg n => / x ^ pnat n end.
Fixpoint prodz (l : list (R * Z * R)) : R := match l with nil => 1 | (p, k, _) :: t => zpow p k * prodz t end.
Fixpoint sumz (l : list (R * Z * R)) : R := match l with nil => 0 | (_, k, q) :: t => IZR k * q + sumz t end.
Fixpoint logs (l : list (R * Z * R)) : Prop := match l with nil => True | (p, _, q) :: t => (0 < p /\ ln p = q) /\ logs t end.

Lemma zpow_pos : forall x k, 0 < x -> 0 < zpow x k.
Proof. intros x [| n | n] h; cbn; [lra | now apply pow_lt | apply Rinv_0_lt_compat; now apply pow_lt]. Qed.
Lemma ln_pow' : forall x n, 0 < x -> ln (x ^ n) = INR n * ln x.
Proof. intros x n h. rewrite <- Rpower_pow by exact h. unfold Rpower. apply ln_exp. Qed.
Lemma ln_zpow : forall x k, 0 < x -> ln (zpow x k) = IZR k * ln x.
Proof.
  intros x [| n | n] h; cbn [zpow].
  - rewrite ln_1. ring.
  - rewrite ln_pow' by exact h. rewrite pnat_ok, INR_IZR_INZ, positive_nat_Z. reflexivity.
  - rewrite ln_Rinv by now apply pow_lt. rewrite ln_pow' by exact h. rewrite pnat_ok, INR_IZR_INZ, positive_nat_Z.
    change (Zneg n) with (- Zpos n)%Z. rewrite opp_IZR. ring.
Qed.
Lemma prodz_pos : forall l, logs l -> 0 < prodz l.
Proof. induction l as [| [[p k] q] l IH]; cbn; [lra |]. intros ((h & _) & g). apply Rmult_lt_0_compat; [now apply zpow_pos | now apply IH]. Qed.
Lemma ln_prodz : forall l, logs l -> ln (prodz l) = sumz l.
Proof.
  induction l as [| [[p k] q] l IH]; cbn; [intros; apply ln_1 |]. intros ((h & <-) & g).
  rewrite ln_mult; [| now apply zpow_pos | now apply prodz_pos]. rewrite ln_zpow by exact h. rewrite IH by exact g. reflexivity.
Qed.

Lemma rpower_leaf : forall X Y V lx lv, logs lx -> logs lv -> X = prodz lx -> V = prodz lv -> Y * sumz lx = sumz lv -> Rpower X Y = V.
Proof.
  intros X Y V lx lv hx hv -> -> e. unfold Rpower. rewrite ln_prodz by exact hx. rewrite e, <- ln_prodz by exact hv.
  apply exp_ln, prodz_pos, hv.
Qed.
Lemma pow_leaf : forall X n V lx lv, logs lx -> logs lv -> X = prodz lx -> V = prodz lv -> INR n * sumz lx = sumz lv -> X ^ n = V.
Proof.
  intros X n V lx lv hx hv e1 e2 e. rewrite <- Rpower_pow by (rewrite e1; now apply prodz_pos).
  now apply (rpower_leaf _ _ _ lx lv).
Qed.
Lemma sqrt_leaf : forall X V lx lv, logs lx -> logs lv -> X = prodz lx -> V = prodz lv -> / 2 * sumz lx = sumz lv -> sqrt X = V.
Proof.
  intros X V lx lv hx hv e1 e2 e. rewrite <- Rpower_sqrt by (rewrite e1; now apply prodz_pos).
  now apply (rpower_leaf _ _ _ lx lv).
Qed.
Lemma cbrt_leaf : forall X V lx lv, logs lx -> logs lv -> X = prodz lx -> V = prodz lv -> 1 / 3 * sumz lx = sumz lv -> cbrt X = V.
Proof. intros. unfold cbrt. now apply (rpower_leaf _ _ _ lx lv). Qed.
Lemma exp_leaf : forall X V lv, logs lv -> V = prodz lv -> X = sumz lv -> exp X = V.
Proof. intros X V lv hv -> ->. rewrite <- ln_prodz by exact hv. apply exp_ln, prodz_pos, hv. Qed.
Lemma ln_leaf : forall X V lx, logs lx -> X = prodz lx -> sumz lx = V -> ln X = V.
Proof. intros X V lx h -> <-. now apply ln_prodz. Qed.
Lemma same_logs : forall A B la lb, logs la -> logs lb -> A = prodz la -> B = prodz lb -> sumz la = sumz lb -> A = B.
Proof. intros A B la lb ha hb -> -> e. rewrite <- (exp_ln (prodz la)), <- (exp_ln (prodz lb)) by now apply prodz_pos. rewrite !ln_prodz by assumption. now rewrite e. Qed.

Lemma inv_pow_leaf : forall X n V lx lv, logs lx -> logs lv -> X = prodz lx -> V = prodz lv -> IZR (-1) * INR n * sumz lx = sumz lv -> / X ^ n = V.
Proof.
  intros X n V lx lv hx hv e1 e2 e. assert (hp : 0 < prodz lx) by now apply prodz_pos. rewrite <- Rpower_pow by (rewrite e1; exact hp).
  rewrite <- Rpower_Ropp. apply (rpower_leaf _ _ _ lx lv); try assumption. rewrite <- e. ring.
Qed.
Fixpoint prodn (n : nat) (l : list (R * Z * R)) : R := match l with nil => 1 | (p, k, _) :: t => zpow (p ^ n) k * prodn n t end.
Lemma zpow_power : forall x k n, zpow x k ^ n = zpow (x ^ n) k.
Proof.
  intros x [| m | m] n; cbn [zpow].
  - apply pow1.
  - rewrite <- !pow_mult. now rewrite Nat.mul_comm.
  - rewrite pow_inv, <- !pow_mult. now rewrite Nat.mul_comm.
Qed.
Lemma pow_of_prod : forall X n l, X = prodz l -> X ^ n = prodn n l.
Proof. intros X n l ->. induction l as [| [[p k] q] l IH]; cbn; [apply pow1 |]. now rewrite Rpow_mult_distr, zpow_power, IH. Qed.
Lemma same_times : forall a b u x y, a = u * x -> x = y -> b = u * y -> a = b. Proof. intros a b u x y -> -> ->. reflexivity. Qed.
Lemma prime_log : forall x, 0 < x -> 0 < x /\ ln x = ln x. Proof. intros x h. now split. Qed.
Lemma ln_of_rpower : forall b E S, ln b = S -> ln (Rpower b E) = E * S.
Proof. intros b E S <-. unfold Rpower. apply ln_exp. Qed.
Lemma ln_of_pow : forall b n S, 0 < b -> ln b = S -> ln (b ^ n) = INR n * S.
Proof. intros b n S h <-. now apply ln_pow'. Qed.
Lemma ln_of_root : forall b S, 0 < b -> ln b = S -> ln (sqrt b) = 1 / 2 * S.
Proof. intros b S h <-. rewrite <- Rpower_sqrt by exact h. unfold Rpower. rewrite ln_exp. f_equal. lra. Qed.
Lemma sech_is : forall x, sech x = 1 / cosh x. Proof. intro x. unfold sech. rewrite <- (Rmult_1_l (/ cosh x)). reflexivity. Qed.
Lemma tanh_is : forall x, tanh x = sinh x / cosh x. Proof. reflexivity. Qed.
Lemma same_cons : forall (A : Type) (x y : A) (s t : list A), x = y -> s = t -> x :: s = y :: t. Proof. intros A x y s t <- <-. reflexivity. Qed.

(** * Identities: the values of variables are put in, divisors stay variables that are not 0. *)
Definition stands (p v : R) : Prop := p = v.
Ltac put_in := repeat match goal with H : stands _ _ |- _ => unfold stands in H; subst end.
(* What is not 0, up to a number: 2 * p where p is not 0. *)
Ltac not_null := first [assumption | let h := fresh in intro h; match goal with H : _ <> 0 |- _ => solve [apply H; lra] end].
Ltac identity := intros; subst; first
  [ reflexivity
  | lazymatch goal with |- context [/ _] => fail | |- context [_ / _] => fail | _ => solve [put_in; ring] end
  | lazymatch goal with _ : stands _ _ |- _ => solve [put_in; field; repeat split; not_null] end
  | (field; solve [repeat split; not_null])
  | solve [put_in; ring]
  | (field_simplify_eq; [put_in; ring | repeat split; not_null])
  | solve [put_in; unfold Rdiv; ring] ].
Ltac existence H F := first [exact (F H) | let x := fresh in let K := fresh in destruct H as [x K]; first [existence K (F x) | existence K F]].
Ltac nat_power n m := replace n with m by (first [lia | ring]); rewrite ?pow_add, ?pow_mult; ring.

(** * Powers rise; the weighted mean; induction *)
Lemma mono_lt : forall a b p, 0 < a -> 0 < b -> 0 < p -> a < b -> Rpower a p < Rpower b p.
Proof. intros a b p ha hb hp h. unfold Rpower. apply exp_increasing. apply Rmult_lt_compat_l; [exact hp |]. now apply ln_increasing. Qed.
Lemma exp_tangent : forall s, 1 + s <= exp s.
Proof. intro s. destruct (Req_dec s 0) as [-> | h]; [rewrite exp_0; lra | left; now apply exp_ineq1]. Qed.

Lemma mean_weak : forall a b p, 0 < a -> 0 < b -> 0 <= p <= 1 -> Rpower a (1 - p) * Rpower b p <= (1 - p) * a + p * b.
Proof.
  intros a b p ha hb hp. set (G := Rpower a (1 - p) * Rpower b p).
  assert (hg : 0 < G) by (apply Rmult_lt_0_compat; apply exp_pos).
  assert (lg : ln G = (1 - p) * ln a + p * ln b).
  { unfold G. rewrite ln_mult by apply exp_pos. unfold Rpower. now rewrite !ln_exp. }
  assert (q : forall x, 0 < x -> x >= G * (1 + (ln x - ln G))).
  { intros x hx. assert (e := exp_tangent (ln x - ln G)). unfold Rminus in e at 2. rewrite exp_plus, exp_Ropp, exp_ln, exp_ln in e by assumption.
    replace x with (G * (x * / G)) at 1 by (field; lra). apply Rle_ge. apply Rmult_le_compat_l; lra. }
  assert (qa := q a ha). assert (qb := q b hb).
  assert (e : G = (1 - p) * (G * (1 + (ln a - ln G))) + p * (G * (1 + (ln b - ln G)))) by (rewrite lg; ring). 
  nra.
Qed.

Lemma mean_strict : forall a b p, 0 < a -> 0 < b -> 0 < p < 1 -> a <> b -> Rpower a (1 - p) * Rpower b p < (1 - p) * a + p * b.
Proof.
  intros a b p ha hb hp hab. set (G := Rpower a (1 - p) * Rpower b p).
  assert (hg : 0 < G) by (apply Rmult_lt_0_compat; apply exp_pos).
  assert (lg : ln G = (1 - p) * ln a + p * ln b).
  { unfold G. rewrite ln_mult by apply exp_pos. unfold Rpower. now rewrite !ln_exp. }
  assert (hl : ln a <> ln b) by (intro e; apply hab; now apply ln_inv).
  assert (q : forall x, 0 < x -> ln x <> ln G -> x > G * (1 + (ln x - ln G))).
  { intros x hx hn. assert (e := exp_ineq1 (ln x - ln G) ltac:(lra)). unfold Rminus in e at 2. rewrite exp_plus, exp_Ropp, exp_ln, exp_ln in e by assumption.
    replace x with (G * (x * / G)) at 1 by (field; lra). apply Rmult_lt_compat_l; lra. }
  assert (na : ln a <> ln G) by (rewrite lg; intro e; apply hl; assert (p * (ln a - ln b) = 0) by lra; nra).
  assert (nb : ln b <> ln G) by (rewrite lg; intro e; apply hl; assert ((1 - p) * (ln a - ln b) = 0) by lra; nra).
  assert (qa := q a ha na). assert (qb := q b hb nb).
  assert (e : G = (1 - p) * (G * (1 + (ln a - ln G))) + p * (G * (1 + (ln b - ln G)))) by (rewrite lg; ring).
  nra.
Qed.

Lemma nat_from : forall (P : nat -> Prop) b, P b -> (forall n, INR n >= INR b -> P n -> P (n + 1)%nat) -> forall n, INR n >= INR b -> P n.
Proof.
  intros P b h s n hn. assert (k : (b <= n)%nat) by (apply INR_le; lra). clear hn.
  induction k; [exact h |]. replace (S m) with (m + 1)%nat by lia. apply s; [apply Rle_ge, le_INR, k | exact IHk].
Qed.
Lemma nat_ind1 : forall (P : nat -> Prop), P 0%nat -> (forall n, P n -> P (n + 1)%nat) -> forall n, P n.
Proof. intros P h s n. induction n; [exact h |]. replace (S n) with (n + 1)%nat by lia. now apply s. Qed.

(** * Sums and products over a range *)
Lemma product_ext : forall a b f g, (forall k, (a <= k < b + 1)%nat -> f k = g k) -> product_over a b f = product_over a b g.
Proof.
  intros a b f g h. unfold product_over. assert (q : forall c, (a + c <= b + 1)%nat -> product_terms f a c = product_terms g a c).
  { induction c; intro hc; cbn; [reflexivity |]. rewrite IHc by lia. rewrite h by lia. reflexivity. }
  destruct (Nat.le_gt_cases a (b + 1)). - apply q. lia. - replace (b + 1 - a)%nat with 0%nat by lia. reflexivity.
Qed.
Lemma sum_ext : forall a b f g, (forall k, (a <= k < b + 1)%nat -> f k = g k) -> sum_over a b f = sum_over a b g.
Proof.
  intros a b f g h. unfold sum_over. assert (q : forall c, (a + c <= b + 1)%nat -> sum_terms f a c = sum_terms g a c).
  { induction c; intro hc; cbn; [reflexivity |]. rewrite IHc by lia. rewrite h by lia. reflexivity. }
  destruct (Nat.le_gt_cases a (b + 1)). - apply q. lia. - replace (b + 1 - a)%nat with 0%nat by lia. reflexivity.
Qed.
Lemma sum_ext2 : forall a a' b b' f g, a = a' -> b = b' -> (forall k, (a <= k < b + 1)%nat -> f k = g k) -> sum_over a b f = sum_over a' b' g.
Proof. intros a a' b b' f g <- <-. apply sum_ext. Qed.
Lemma product_mult : forall a b f g, product_over a b (fun k => f k * g k) = product_over a b f * product_over a b g.
Proof. intros. unfold product_over. induction (b + 1 - a)%nat; cbn; [ring | rewrite IHn; ring]. Qed.
Lemma product_pow : forall a b f m, product_over a b (fun k => f k ^ m) = product_over a b f ^ m.
Proof. intros. unfold product_over. induction (b + 1 - a)%nat; cbn [product_terms]; [now rewrite pow1 | rewrite IHn; now rewrite Rpow_mult_distr]. Qed.
Lemma product_inv : forall a b f, product_over a b (fun k => / f k) = / product_over a b f.
Proof. intros. unfold product_over. induction (b + 1 - a)%nat; cbn; [now rewrite Rinv_1 | rewrite IHn; now rewrite Rinv_mult]. Qed.
Lemma product_empty : forall a b f, (b + 1 = a)%nat -> product_over a b f = 1.
Proof. intros a b f h. unfold product_over. now replace (b + 1 - a)%nat with 0%nat by lia. Qed.
Lemma sum_empty : forall a b f, (b + 1 = a)%nat -> sum_over a b f = 0.
Proof. intros a b f h. unfold sum_over. now replace (b + 1 - a)%nat with 0%nat by lia. Qed.
Lemma product_last : forall a b c f, (c + 1 = b)%nat -> (a <= b)%nat -> product_over a b f = product_over a c f * f b.
Proof. intros a b c f h g. unfold product_over. replace (b + 1 - a)%nat with (S (c + 1 - a)) by lia. cbn. now replace (a + (c + 1 - a))%nat with b by lia. Qed.
Lemma sum_last : forall a b c f, (c + 1 = b)%nat -> (a <= b)%nat -> sum_over a b f = sum_over a c f + f b.
Proof. intros a b c f h g. unfold sum_over. replace (b + 1 - a)%nat with (S (c + 1 - a)) by lia. cbn. now replace (a + (c + 1 - a))%nat with b by lia. Qed.

Lemma terms_first : forall f a c, product_terms f a (S c) = product_terms f (a + 1) c * f a.
Proof. intros f a c. induction c; [cbn; replace (a + 0)%nat with a by lia; ring |].
  change (product_terms f a (S c) * f (a + S c)%nat = product_terms f (a + 1) c * f (a + 1 + c)%nat * f a).
  rewrite IHc. replace (a + S c)%nat with (a + 1 + c)%nat by lia. ring. Qed.
Lemma sterms_first : forall f a c, sum_terms f a (S c) = sum_terms f (a + 1) c + f a.
Proof. intros f a c. induction c; [cbn; replace (a + 0)%nat with a by lia; ring |].
  change (sum_terms f a (S c) + f (a + S c)%nat = sum_terms f (a + 1) c + f (a + 1 + c)%nat + f a).
  rewrite IHc. replace (a + S c)%nat with (a + 1 + c)%nat by lia. ring. Qed.
Lemma product_first : forall a b c f, (a + 1 = c)%nat -> (a <= b)%nat -> product_over a b f = product_over c b f * f a.
Proof. intros a b c f h g. unfold product_over. subst c. replace (b + 1 - a)%nat with (S (b + 1 - (a + 1))) by lia. apply terms_first. Qed.
Lemma sum_first : forall a b c f, (a + 1 = c)%nat -> (a <= b)%nat -> sum_over a b f = sum_over c b f + f a.
Proof. intros a b c f h g. unfold sum_over. subst c. replace (b + 1 - a)%nat with (S (b + 1 - (a + 1))) by lia. apply sterms_first. Qed.
Lemma ln_sign : forall s x, 0 < x -> holds s (x - 1) -> holds s (ln x).
Proof.
  intros s x h (h1 & h2 & h3). destruct (Rtotal_order x 1) as [g | [g | g]].
  - assert (ln x < 0) by (rewrite <- ln_1; now apply ln_increasing). split; [| split]; intro; first [apply h1; lra | exfalso; lra].
  - assert (ln x = 0) by (rewrite g; apply ln_1). split; [| split]; intro; first [apply h2; lra | exfalso; lra].
  - assert (0 < ln x) by (rewrite <- ln_1; apply ln_increasing; lra). split; [| split]; intro; first [apply h3; lra | exfalso; lra].
Qed.

Lemma second_derivative : forall (f g : R -> R) x a v, (forall y, y > a -> Derive f y = g y) -> x > a -> is_derive g x v -> is_derive_n f 2 x v.
Proof.
  intros f g x a v h hx hg. cbn. apply (is_derive_ext_loc g); [| exact hg].
  assert (e : 0 < x - a) by lra. exists (mkposreal _ e). intros y hy. symmetry. apply h.
  unfold ball in hy. cbn in hy. unfold AbsRing_ball, abs, minus, plus, opp in hy. cbn in hy. apply Rabs_def2 in hy. lra.
Qed.
Lemma second_derivative_all : forall (f g : R -> R) x v, (forall y, Derive f y = g y) -> is_derive g x v -> is_derive_n f 2 x v.
Proof. intros f g x v h hg. cbn. apply (is_derive_ext g); [intro y; symmetry; apply h | exact hg]. Qed.
(** * Limits of quotients in 1/x, and between two others *)
Lemma lim_inv_R : forall P Q : R -> R, ex_derive P 0 -> ex_derive Q 0 -> Q 0 <> 0 -> is_lim (fun x => P (/ x) / Q (/ x)) p_infty (P 0 / Q 0).
Proof.
  intros P Q hP hQ hq. assert (z : is_lim (fun x => / x) p_infty 0).
  { evar_last. apply is_lim_inv; [apply is_lim_id | discriminate]. reflexivity. }
  assert (c : forall f : R -> R, ex_derive f 0 -> is_lim (fun x => f (/ x)) p_infty (f 0)).
  { intros f hf. exact (filterlim_comp _ _ _ (fun x => / x) f _ _ _ z (ex_derive_continuous f 0 hf)). }
  evar_last. apply is_lim_div; [apply c, hP | apply c, hQ | | ]; cbn; try (intro k; injection k; exact hq).
  - unfold is_Rbar_div, is_Rbar_mult, Rbar_mult'. cbn. reflexivity.
  - cbn. reflexivity.
Qed.
Lemma lim_inv : forall f (P Q : R -> R) v b, (forall x, x > b -> f x = P (/ x) / Q (/ x)) -> ex_derive P 0 -> ex_derive Q 0 -> Q 0 <> 0 -> P 0 / Q 0 = v -> is_lim f p_infty v.
Proof.
  intros f P Q v b h hP hQ hq <-. apply (is_lim_ext_loc (fun x => P (/ x) / Q (/ x))); [| now apply lim_inv_R].
  exists b. intros x hx. symmetry. apply h. lra.
Qed.
Lemma lim_seq_inv : forall f (P Q : R -> R) v b, (forall n : nat, INR n > b -> f n = P (/ INR n) / Q (/ INR n)) -> ex_derive P 0 -> ex_derive Q 0 -> Q 0 <> 0 -> P 0 / Q 0 = v -> is_lim_seq f v.
Proof.
  intros f P Q v b h hP hQ hq <-. apply (is_lim_seq_ext_loc (fun n => P (/ INR n) / Q (/ INR n))).
  - assert (g := is_lim_seq_INR). apply is_lim_seq_spec in g. destruct (g b) as [N hN]. exists N. intros n hn. symmetry. apply h. apply hN, hn.
  - apply (is_lim_comp_seq (fun x => P (/ x) / Q (/ x)) INR p_infty); [now apply lim_inv_R | now exists 0%nat | apply is_lim_seq_INR].
Qed.
Lemma squeeze_seq : forall f lo hi (v : R) b, (forall n : nat, INR n > b -> lo n <= f n /\ f n <= hi n) -> is_lim_seq lo v -> is_lim_seq hi v -> is_lim_seq f v.
Proof.
  intros f lo hi v b h hl hh. apply (is_lim_seq_le_le_loc lo f hi); [| exact hl | exact hh].
  assert (g := is_lim_seq_INR). apply is_lim_seq_spec in g. destruct (g b) as [N hN]. exists N. intros n hn. apply h. apply hN, hn.
Qed.
Lemma squeeze_lim : forall f lo hi (v : R) b, (forall x : R, x > b -> lo x <= f x /\ f x <= hi x) -> is_lim lo p_infty v -> is_lim hi p_infty v -> is_lim f p_infty v.
Proof.
  intros f lo hi v b h hl hh. apply (is_lim_le_le_loc lo hi f p_infty v); [| exact hl | exact hh]. exists b. intros x hx. apply h. lra.
Qed.
Lemma along_lim : forall (f : R -> R) (v : R), is_lim (fun y => f (exp y)) p_infty v -> is_lim f p_infty v.
Proof.
  intros f v h. apply (is_lim_ext_loc (fun x => f (exp (ln x)))).
  - exists 0. intros x hx. now rewrite exp_ln.
  - apply (is_lim_comp (fun y => f (exp y)) ln p_infty v p_infty h is_lim_ln_p). now exists 0.
Qed.
Lemma along_seq : forall (f : R -> R) (v : R), is_lim (fun y => f (exp y)) p_infty v -> is_lim_seq (fun n => f (INR n)) v.
Proof.
  intros f v h. apply (is_lim_comp_seq f INR p_infty); [now apply along_lim | now exists 0%nat | apply is_lim_seq_INR].
Qed.
Lemma eventually_lim : forall (f : R -> R) (v e b : R), is_lim f p_infty v -> 0 < e -> exists N, N > b /\ forall x, x >= N -> v - e < f x < v + e.
Proof.
  intros f v e b h he. apply is_lim_spec in h. destruct (h (mkposreal e he)) as [M hM]. exists (Rmax M b + 1). split.
  - assert (c := Rmax_r M b). lra.
  - intros x hx. assert (c := Rmax_l M b). assert (g : M < x) by lra. apply hM, Rabs_def2 in g. cbn in g. lra.
Qed.
Lemma eventually_seq : forall (f : nat -> R) (v e b : R), is_lim_seq f v -> 0 < e -> exists N : nat, INR N > b /\ forall n : nat, (n >= N)%nat -> v - e < f n < v + e.
Proof.
  intros f v e b h he. apply is_lim_seq_spec in h. destruct (h (mkposreal e he)) as [M hM].
  assert (g := is_lim_seq_INR). apply is_lim_seq_spec in g. destruct (g b) as [K hK]. exists (M + K)%nat. split; [apply hK; lia |].
  intros n hn. assert (k : (M <= n)%nat) by lia. apply hM, Rabs_def2 in k. cbn in k. lra.
Qed.

(** * Tactics of the generated proofs *)

Lemma named : forall x : R, exists r, x = r. Proof. intro x. now exists x. Qed.
Lemma rpower_is_positive : forall x y, holds GT (Rpower x y). Proof. intros. apply of_pos, exp_pos. Qed.
Lemma exp_is_positive : forall x, holds GT (exp x). Proof. intros. apply of_pos, exp_pos. Qed.
Lemma power_is_positive : forall x n, 0 < x -> holds GT (x ^ n). Proof. intros. now apply of_pos, pow_lt. Qed.
Lemma by_logarithms : forall a b, 0 < a -> 0 < b -> ln a = ln b -> a = b.
Proof. intros. now apply ln_inv. Qed.
Lemma ln_rpower : forall x y, ln (Rpower x y) = y * ln x. Proof. intros. unfold Rpower. apply ln_exp. Qed.
Lemma ln_quotient : forall a b, 0 < a -> 0 < b -> ln (a / b) = ln a - ln b.
Proof. intros. unfold Rdiv. rewrite ln_mult, ln_Rinv; [ring | assumption | assumption | now apply Rinv_0_lt_compat]. Qed.
Lemma ln_root : forall x, 0 < x -> ln (sqrt x) = / 2 * ln x.
Proof. intros. rewrite <- Rpower_sqrt by assumption. apply ln_rpower. Qed.

(** INR of a sum or product is taken apart, numerals become real ones and stand last in sums. *)
Ltac closed_nat k := lazymatch k with O => idtac | S ?m => closed_nat m end.
Ltac numerals := repeat match goal with |- context [INR ?k] => closed_nat k;
  let z := eval cbv in (Z.of_nat k) in replace (INR k) with (IZR z) by (cbn [INR]; ring) end.
Ltac pushinr := repeat first [rewrite plus_INR | rewrite mult_INR | rewrite pow_INR]; numerals;
  repeat match goal with |- context [IZR ?c + INR ?n] => rewrite (Rplus_comm (IZR c) (INR n)) end.
Ltac natural_value := pushinr; first [ring | (rewrite ?pow_add; ring)].
Ltac naturals := repeat match goal with
  | H : (?a >= ?b)%nat |- _ => apply le_INR in H
  | H : (?a <= ?b)%nat |- _ => apply le_INR in H
  | H : (?a > ?b)%nat |- _ => apply lt_INR in H
  | H : (?a < ?b)%nat |- _ => apply lt_INR in H
  end; rewrite ?plus_INR, ?mult_INR in *; cbn [INR] in *.

Lemma cosh_pos : forall x, 0 < cosh x.
Proof. intro x. unfold cosh. assert (a := exp_pos x). assert (b := exp_pos (- x)). lra. Qed.

(** Positive, by the facts that say so of its parts. *)
Ltac pos := first
  [ assumption
  | lazymatch goal with
    | |- 0 < _ * _ => apply Rmult_lt_0_compat; pos
    | |- 0 < _ / _ => apply Rdiv_lt_0_compat; pos
    | |- 0 < / _ => apply Rinv_0_lt_compat; pos
    | |- 0 < _ ^ _ => apply pow_lt; pos
    | |- 0 < exp _ => apply exp_pos
    | |- 0 < Rpower _ _ => apply exp_pos
    | |- 0 < cbrt _ => apply exp_pos
    | |- 0 < cosh _ => apply cosh_pos
    | |- 0 < sqrt _ => apply sqrt_lt_R0; pos
    | |- 0 < _ + _ => apply Rplus_lt_0_compat; pos
    end
  | lra
  | (pushinr; lra) ].
Ltac nz1 := first
  [ assumption
  | lazymatch goal with
    | |- _ * _ <> 0 => apply Rmult_integral_contrapositive_currified; nz1
    | |- _ ^ _ <> 0 => apply pow_nonzero; nz1
    | |- / _ <> 0 => apply Rinv_neq_0_compat; nz1
    | |- _ / _ <> 0 => apply Rmult_integral_contrapositive_currified; nz1
    end
  | match goal with H : ?p <> 0 |- ?q <> 0 => solve [let z := fresh in intro z; apply H; lra] end
  | (apply Rgt_not_eq; red; pos)
  | lra
  | match goal with H : ?p <> 0 |- ?q <> 0 => solve [let z := fresh in intro z; apply H; ring_simplify; ring_simplify in z; lra] end ].
Ltac nz := repeat split; nz1.
Ltac entries := cbn [mat_scale mat_mul mat_add row_add row_times map det2].
Ltac fld := first [reflexivity | ring | (field; nz) | (entries; first [ring | field; nz]) | (pushinr; first [ring | field; nz])].

(** A hypothesis, as the statement writes it or as the proof does. *)
Ltac apart_all := repeat match goal with H : _ /\ _ |- _ => destruct H end. Ltac at_hand := first [assumption | lra].
Ltac at_index k := repeat match goal with H : forall _ : nat, _ |- _ => let z := fresh in assert (z := H k); clear H end.
Ltac hyp := first
  [ assumption
  | solve [apart_all; at_hand]
  | solve [naturals; apart_all; pushinr; first [at_hand | (repeat split; lra)]]
  | solve [apply INR_le; pushinr; naturals; lra]
  | solve [apply INR_lt; pushinr; naturals; lra] | solve [f_equal; assumption] | solve [apply INR_eq; at_hand]
  | solve [repeat split; first [at_hand | (naturals; lra)]]
  | match goal with H : exists _, _ |- exists _, _ => let x := fresh in destruct H as [x ?]; exists x; hyp end
  | solve [let k := fresh in intro k; at_index k; apart_all; repeat split; at_hand]
  | solve [intros; repeat split; intros; match goal with H : forall _, _ |- _ => first [apply H; at_hand | apply H] end] ].

(** The logarithm of a product of positive numbers. *)
Ltac logs := repeat first
  [ rewrite ln_rpower | rewrite ln_exp | rewrite ln_1
  | match goal with
    | |- context [ln (?a * ?b)] => rewrite (ln_mult a b) by pos
    | |- context [ln (?a / ?b)] => rewrite (ln_quotient a b) by pos
    | |- context [ln (/ ?a)] => rewrite (ln_Rinv a) by pos
    | |- context [ln (?a ^ ?n)] => rewrite (ln_pow' a n) by pos
    | |- context [ln (sqrt ?a)] => rewrite (ln_root a) by pos
    end ].
Ltac same_arguments := repeat match goal with
  | |- context [ln ?a] => match goal with |- context [ln ?b] =>
      first [constr_eq a b; fail 1 | replace (ln b) with (ln a) by (apply f_equal; solve [fld | (pushinr; fld)])] end end.
Ltac logfield := pushinr; first [ring | (field; nz) | (same_arguments; first [ring | (field; nz)])].
Ltac unroot := unfold sech, tanh, cosh, sinh, cbrt in *.

(** Equations between products of powers; [k] writes the exponents by the names of powers. *)
Ltac hide_logs := repeat match goal with |- context [ln ?a] => generalize (ln a); intro end.
Ltac pw k := first
  [ reflexivity | ring | (field; nz)
  | (apply f_equal; first [ring | (field; nz)])
  | (pushinr; first [ring | (field; nz)])
  | (rewrite ?pow_add, ?pow_mult, ?Rpow_mult_distr, ?pow1; first [reflexivity | ring | (field; nz)])
  | (apply by_logarithms; [pos | pos | logs; first [logfield | (hide_logs; k; logfield)]])
  | (logs; first [logfield | (hide_logs; k; logfield)])
  | (unroot; apply by_logarithms; [pos | pos | logs; first [logfield | (hide_logs; k; logfield)]]) 
  | (unroot; k; rewrite ?Ropp_involutive; first [ring | field; nz]) ].

Lemma divided : forall env se t D sd d s, ok env se -> holds sd D -> D * d = ev env t -> within sd NE = true ->
  within (times (sgn se t) sd) s = true -> holds s d.
Proof.
  intros env se t D sd d s h hD e w1 w2. assert (nz : D <> 0) by (apply to_nz; now apply (weaken _ _ _ w1)).
  assert (q : holds (sgn se t) (D * d)) by (rewrite e; now apply sgn_sound).
  apply (weaken _ _ _ w2). replace d with ((D * d) * / D) by (field; exact nz).
  apply holds_times; [exact q | now apply holds_inv].
Qed.
Lemma to_ge0 : forall a, holds GE a -> 0 <= a.
Proof. intros a (h1 & h2 & h3). cbn in *. destruct (three a) as [h | [h | h]]; [discriminate (h1 h) | lra | lra]. Qed.
Lemma mean_weak_signs : forall a b p, holds GT a -> holds GT b -> holds GE p -> holds GE (1 - p) ->
  Rpower a (1 - p) * Rpower b p <= (1 - p) * a + p * b.
Proof. intros a b p ha hb hp hq. apply to_pos in ha, hb. apply to_ge0 in hp, hq. apply mean_weak; lra. Qed.
Lemma mean_strict_signs : forall a b p, holds GT a -> holds GT b -> holds GT p -> holds GT (1 - p) -> holds NE (a - b) ->
  Rpower a (1 - p) * Rpower b p < (1 - p) * a + p * b.
Proof. intros a b p ha hb hp hq hn. apply to_pos in ha, hb, hp, hq. apply to_ne in hn. apply mean_strict; lra. Qed.
Lemma tangent_weak : forall x, 1 + x <= exp x.
Proof. exact exp_ineq1_le. Qed.
Lemma tangent_strict : forall x, holds NE x -> 1 + x < exp x.
Proof. intros x h. apply exp_ineq1. now apply to_nz. Qed.

(** A part of a fact that is a conjunction. *)
Ltac part h := let z := fresh in assert (z := h); apart_all; assumption.
(** The sign of a member, from what its family says of all. *)
Ltac family x := lazymatch x with ?f ?i => 
  repeat match goal with H : forall k : nat, _ |- _ => let z := fresh in assert (z := H i); clear H end;
  apart_all; unfold LT, LE, EQ, NE, GE, GT; repeat split; cbn [neg zer pos]; intro; first [reflexivity | exfalso; lra] end.
Ltac matrices := entries; repeat match goal with |- @cons _ _ _ = _ => apply f_equal2 | |- nil = nil => reflexivity end.
(** Facts for all natural numbers at the indices of the goal, and one form for indices that are the same. *)
Ltac simple_fact t := lazymatch t with
  | _ < _ => idtac | _ <= _ => idtac | _ > _ => idtac | _ >= _ => idtac | _ = _ => fail
  | ?a /\ _ => simple_fact a
  | (_ <= _ <= _)%nat -> ?b => simple_fact b | INR _ >= _ -> ?b => simple_fact b | INR _ <= _ -> ?b => simple_fact b end.
Ltac at_members := repeat match goal with
  | H : forall j : nat, _ |- context [_ ?i] => lazymatch type of i with nat => idtac end;
      let t := type of (H i) in let t := eval cbv beta in t in simple_fact t;
      lazymatch goal with _ : t |- _ => fail | _ => assert t by exact (H i) end end;
  repeat match goal with H : ?A -> ?B |- _ => lazymatch type of A with Prop => simple_fact (A -> B); specialize (H ltac:(first [lia | lra | hyp])) end end;
  apart_all.
Ltac same_indices := repeat match goal with |- context [?f ?i] => lazymatch type of i with nat => idtac end;
  match goal with |- context [f ?j] => lazymatch i with context [j] => fail | _ => replace j with i by lia end end end.
Ltac at_index_positive := apart_all; repeat match goal with H : (?a <= ?k)%nat |- _ =>
  lazymatch goal with _ : 0 < INR k |- _ => fail | _ => assert (0 < INR k) by (apply lt_0_INR; lia) end end.
Ltac body := cbv beta; intros; same_indices; at_members; first
  [ reflexivity | (pushinr; first [ring | (field; nz)])
  | (at_index_positive; pushinr; rewrite ?pow_add; first [ring | (field; nz) | pw ltac:(idtac)]) ].
Lemma sum_scale : forall c a b f, c * sum_over a b f = sum_over a b (fun k => c * f k).
Proof. intros. unfold sum_over. induction (b + 1 - a)%nat; cbn; [ring | rewrite <- IHn; ring]. Qed.
Lemma sum_plus : forall a b f g, sum_over a b f + sum_over a b g = sum_over a b (fun k => f k + g k).
Proof. intros. unfold sum_over. induction (b + 1 - a)%nat; cbn; [ring | rewrite <- IHn; ring]. Qed.
Lemma product_ext2 : forall a a' b b' f g, a = a' -> b = b' -> (forall k, (a <= k < b + 1)%nat -> f k = g k) -> product_over a b f = product_over a' b' g.
Proof. intros a a' b b' f g <- <-. apply product_ext. Qed.
Lemma sum_le2 : forall a a' b b' f g, a = a' -> b = b' -> (forall k, (a <= k < b + 1)%nat -> f k <= g k) -> sum_over a b f <= sum_over a' b' g.
Proof.
  intros a a' b b' f g <- <- h. unfold sum_over. assert (q : forall c, (a + c <= b + 1)%nat -> sum_terms f a c <= sum_terms g a c).
  { induction c; intro hc; cbn; [lra |]. apply Rplus_le_compat; [apply IHc | apply h]; lia. }
  destruct (Nat.le_gt_cases a (b + 1)). - apply q. lia. - replace (b + 1 - a)%nat with 0%nat by lia. cbn. lra.
Qed.
(** Sums and products term by term, from the fact [h] for all indices of the range. *)
Ltac termwise h := first
  [ apply sum_ext2 | apply product_ext2 | apply sum_le2 | (apply Rle_ge; apply sum_le2) ];
  [ lia | lia | let k := fresh in let r := fresh in intros k r; cbv beta;
    match type of r with (?a <= _ < ?b + 1)%nat => assert (a <= k /\ k <= b)%nat by lia; clear r end;
    apart_all; first [apply h; hyp | apply Rge_le, h; hyp | apply h | apply Rge_le, h] ].
(** Whole numbers: between one and the next there is none. *)
Definition whole (x : R) : Prop := exists z : Z, x = IZR z.
Lemma whole_nat : forall n, whole (INR n). Proof. intro n. exists (Z.of_nat n). apply INR_IZR_INZ. Qed.
Lemma whole_plus : forall x y, whole x -> whole y -> whole (x + y).
Proof. intros x y [a ->] [b ->]. exists (a + b)%Z. symmetry. apply plus_IZR. Qed.
Lemma whole_times : forall x y, whole x -> whole y -> whole (x * y).
Proof. intros x y [a ->] [b ->]. exists (a * b)%Z. symmetry. apply mult_IZR. Qed.
Lemma whole_pow : forall x n, whole x -> whole (x ^ n).
Proof. intros x n h. induction n; cbn [pow]; [now exists 1%Z | now apply whole_times]. Qed.
Ltac is_whole := lazymatch goal with
  | |- whole (IZR ?z) => exists z; reflexivity
  | |- whole (INR _) => apply whole_nat
  | |- whole (_ + _) => apply whole_plus; is_whole
  | |- whole (_ * _) => apply whole_times; is_whole
  | |- whole (_ ^ _) => apply whole_pow; is_whole
  end.
Lemma whole_step : forall x y c d p, whole p -> x < y -> y - x = p -> d - c = p - 1 -> c <= d.
Proof.
  intros x y c d p [z ->] h e1 e2. assert (hz : (1 <= z)%Z) by (apply (Zlt_le_succ 0), lt_IZR; lra).
  apply IZR_le in hz. lra.
Qed.
(** Without facts: what terms come to by their form. *)
Ltac ends := first [reflexivity | (clear; lia) | lia].
Ltac powers_of_powers := repeat match goal with |- context [?x ^ (?c * ?k)] => closed_nat c; rewrite (Nat.mul_comm c k), (pow_mult x k c) end.
Ltac by_form_alone := clear; let k := fresh in intros k _; cbv beta; same_indices;
  first [reflexivity | ring | (pushinr; rewrite ?pow_add; powers_of_powers; ring)].
Ltac forget := repeat match goal with H : ?t |- _ =>
  lazymatch type of t with Prop => lazymatch t with forall _ : nat, _ => fail | _ => clear H end end end.
Ltac over_by b := first
  [ solve [apply product_ext2; [ends | ends | b]]
  | solve [apply sum_ext2; [ends | ends | b]]
  | solve [rewrite ?sum_scale, ?sum_plus; apply sum_ext2; [ends | ends | b]]
  | solve [unfold Rdiv; rewrite <- ?product_inv, <- ?product_pow, <- ?product_mult; apply product_ext2; [ends | ends | b]] ].
Ltac over := first [reflexivity | over_by ltac:(by_form_alone) | solve [forget; over_by ltac:(body)] | over_by ltac:(body)].
Lemma product_in_gt : forall a b f, (forall k, (a <= k < b + 1)%nat -> 0 < f k) -> holds GT (product_over a b f).
Proof.
  intros a b f h. apply of_pos. unfold product_over.
  assert (q : forall c, (a + c <= b + 1)%nat -> 0 < product_terms f a c).
  { induction c; intro hc; cbn; [lra | apply Rmult_lt_0_compat; [apply IHc; lia | apply h; lia]]. }
  destruct (Nat.le_gt_cases a (b + 1)). - apply q. lia. - replace (b + 1 - a)%nat with 0%nat by lia. cbn. lra.
Qed.
Lemma in_range : forall P : R -> Prop, (forall x y, P x -> P y -> P (x + y)) -> P 0 ->
  forall a b f, (forall k, (a <= k < b + 1)%nat -> P (f k)) -> P (sum_over a b f).
Proof.
  intros P hp h0 a b f h. unfold sum_over. assert (q : forall c, (a + c <= b + 1)%nat -> P (sum_terms f a c)).
  { induction c; intro hc; cbn; [exact h0 | apply hp; [apply IHc | apply h]; lia]. }
  destruct (Nat.le_gt_cases a (b + 1)). - apply q. lia. - replace (b + 1 - a)%nat with 0%nat by lia. exact h0.
Qed.
Lemma sum_in_ge : forall a b f, (forall k, (a <= k < b + 1)%nat -> 0 <= f k) -> holds GE (sum_over a b f).
Proof. intros a b f h. assert (q : 0 <= sum_over a b f) by (apply in_range; [intros; lra | lra | exact h]). from. Qed.
Ltac over_positive := apply product_in_gt; cbv beta; intros; at_members; pos.
Ltac over_not_negative := apply sum_in_ge; cbv beta; intros; at_index_positive; at_members;
  first [apply Rlt_le; pos | apply pow2_ge_0 | lra | nra].
Ltac member_at i := match goal with H : forall k : nat, ?u (k + 1)%nat = _ |- ?u ?t = _ =>
  replace t with (i + 1)%nat by lia; rewrite (H i); body end.
Ltac split_rest := cbv beta; first [ring | (same_indices; ring) | (pushinr; rewrite ?pow_add; ring) | fld].
Ltac split_off := lazymatch goal with
  | |- product_over _ _ _ = 1 => apply product_empty; lia
  | |- sum_over _ _ _ = 0 => apply sum_empty; lia
  | |- product_over ?a ?b ?f = ?r => match r with
    | context [product_over a ?c _] => rewrite (product_last a b c f) by lia; split_rest
    | context [product_over ?c b _] => rewrite (product_first a b c f) by lia; split_rest end
  | |- sum_over ?a ?b ?f = ?r => match r with
    | context [sum_over a ?c _] => rewrite (sum_last a b c f) by lia; split_rest
    | context [sum_over ?c b _] => rewrite (sum_first a b c f) by lia; split_rest end
  end.
Ltac member k := first [assumption | (symmetry; assumption)
  | match goal with H : forall k : nat, ?u (k + 1)%nat = _ |- ?u (?i + 1)%nat = _ => rewrite (H i); k; fld end
  | match goal with H : forall k : nat, ?u (k + 1)%nat = _ |- ?u (1 + ?i)%nat = _ =>
      replace (1 + i)%nat with (i + 1)%nat by lia; rewrite (H i); k; fld end
  | match goal with H : ?u 0%nat = _ |- ?u _ = _ => rewrite H; k; fld end
  | match goal with H : forall k : nat, ?u (k + 1)%nat = _ |- ?u ?j = _ => 
      first [ change j with (0 + 1)%nat; rewrite (H 0%nat); cbn [INR Nat.add]; k; fld
            | change j with (1 + 1)%nat; rewrite (H 1%nat); cbn [INR Nat.add]; k; fld
            | change j with (2 + 1)%nat; rewrite (H 2%nat); cbn [INR Nat.add]; k; fld ] end ].
Ltac induct h s := match goal with |- forall n : nat, @?P n => exact (nat_ind1 P h s) end.
Lemma nat_from_number : forall (P : nat -> Prop) b r, INR b = r -> P b -> (forall n, INR n >= r -> P n -> P (n + 1)%nat) -> forall n, INR n >= r -> P n.
Proof. intros P b r <-. apply nat_from. Qed.
Ltac induct_from h s := first [apply nat_from; [exact h | exact s]
  | lazymatch goal with |- forall n : nat, INR n >= IZR ?z -> _ => let b := eval cbv in (Z.to_nat z) in
      apply (nat_from_number _ b); [cbn [INR]; ring | first [exact h | (numerals; exact h) | (cbn [INR]; exact h)] | exact s] end ].

Lemma rising_pow : forall a b n, (0 < n)%nat -> 0 <= a -> 0 <= b -> (a < b <-> a ^ n < b ^ n).
Proof.
  assert (q : forall a b n, (0 < n)%nat -> 0 <= a -> a < b -> a ^ n < b ^ n).
  { intros a b n hn ha h. induction hn; cbn; [lra |]. assert (0 <= a ^ m) by now apply pow_le. 
    apply Rle_lt_trans with (a * b ^ m); [apply Rmult_le_compat_l; lra | apply Rmult_lt_compat_r; [apply pow_lt; lra | exact h]]. }
  intros a b n hn ha hb. split; [now apply q |]. intro h. destruct (Rtotal_order a b) as [g | [g | g]]; [exact g | subst; lra |].
  assert (z := q b a n hn hb g). lra.
Qed.
Lemma rising_rpower : forall a b p, 0 < p -> 0 < a -> 0 < b -> (a < b <-> Rpower a p < Rpower b p).
Proof.
  intros a b p hp ha hb. split; [now apply mono_lt |]. intro h. destruct (Rtotal_order a b) as [g | [g | g]]; [exact g | subst; lra |].
  assert (z := mono_lt b a p hb ha hp g). lra.
Qed.
Lemma rising_sqrt : forall a b, 0 <= a -> 0 <= b -> (a < b <-> sqrt a < sqrt b).
Proof. intros a b ha hb. split; intro h; [now apply sqrt_lt_1 | now apply sqrt_lt_0]. Qed.
Lemma all_relations : forall a b x y, (a < b <-> x < y) -> (b < a <-> y < x) ->
  (a < b <-> x < y) /\ (a <= b <-> x <= y) /\ (a > b <-> x > y) /\ (a >= b <-> x >= y) /\ (a = b <-> x = y) /\ (a <> b <-> x <> y).
Proof. intros a b x y (h1 & h2) (h3 & h4). unfold Rgt. repeat split; intro h;
  destruct (Rtotal_order a b) as [g | [g | g]]; destruct (Rtotal_order x y) as [k | [k | k]];
  try (assert (g1 := h1 g)); try (assert (g2 := h3 g)); try (assert (g3 := h2 k)); try (assert (g4 := h4 k)); lra. Qed.
Ltac nposit := first [lia | (apply INR_lt; pushinr; cbn [INR]; lra)].
Lemma rise_pow : forall n, (0 < n)%nat -> forall a b, holds GE a -> holds GE b -> (a < b <-> a ^ n < b ^ n).
Proof. intros n hn a b ha hb. apply to_ge0 in ha, hb. now apply rising_pow. Qed.
Lemma rise_rpower : forall p, holds GT p -> forall a b, holds GT a -> holds GT b -> (a < b <-> Rpower a p < Rpower b p).
Proof. intros p hp a b ha hb. apply to_pos in hp, ha, hb. now apply rising_rpower. Qed.
Lemma rise_sqrt : forall a b, holds GE a -> holds GE b -> (a < b <-> sqrt a < sqrt b).
Proof. intros a b ha hb. apply to_ge0 in ha, hb. now apply rising_sqrt. Qed.
Lemma rise_cbrt : forall a b, holds GT a -> holds GT b -> (a < b <-> cbrt a < cbrt b).
Proof. intros a b ha hb. apply to_pos in ha, hb. apply rising_rpower; [lra | exact ha | exact hb]. Qed.
(** Two powers, or their bases, from the comparison [h] of the others; [l] and [r] say that both rise. *)
Ltac raised l r h := let z := fresh in assert (z := all_relations _ _ _ _ l r);
  destruct z as (? & ? & ? & ? & ? & ?); match goal with z : _ <-> _ |- _ => apply z; exact h end.

(** * Square roots of what may be 0 *)
Lemma of_root : forall x, holds GE (sqrt x). Proof. intro x. assert (h := sqrt_pos x). from. Qed.
Lemma same_square : forall a b, 0 <= a -> 0 <= b -> a ^ 2 = b ^ 2 -> a = b.
Proof. intros a b ha hb e. rewrite <- (sqrt_pow2 a ha), <- (sqrt_pow2 b hb). now rewrite e. Qed.
Lemma half_squared : forall x, 0 < x -> Rpower x (1 / 2) ^ 2 = x.
Proof. intros x h. rewrite <- Rpower_pow by apply exp_pos. rewrite Rpower_mult. replace (1 / 2 * INR 2) with 1 by (cbn; lra). now apply Rpower_1. Qed.
Ltac square_of_root := first [apply half_squared; pos | apply pow2_sqrt; first [assumption | apply Rlt_le; pos | lra]].

(** * The mean value theorem *)
(** The values that f has from a to b, and beyond each end the value at that end, make a continuous function. *)
Lemma extended : forall (f : R -> R) a b x, a <= b -> continuous_on (fun t => a <= t <= b) f -> continuous (fun t => f (Rmax a (Rmin b t))) x.
Proof.
  intros f a b x h c. assert (there : forall t, a <= Rmax a (Rmin b t) <= b) by (intro t; unfold Rmax, Rmin; repeat destruct Rle_dec; lra).
  apply (filterlim_comp _ _ _ _ f _ (Hierarchy.within (fun t => a <= t <= b) (locally (Rmax a (Rmin b x))))); [| apply c, there].
  intros P [e q]. exists e. intros y hy. apply q; [| apply there]. apply Rle_lt_trans with (2 := hy).
  change (Rabs (Rmax a (Rmin b y) - Rmax a (Rmin b x)) <= Rabs (y - x)).
  unfold Rmax, Rmin. repeat destruct Rle_dec; unfold Rabs; repeat destruct Rcase_abs; lra.
Qed.
(** Values at a and b compared, by the sign of the derivative strictly between them; at a and b there need not be one. *)
Lemma slope_between : forall (f : R -> R) a b s u w, continuous_on (fun t => a <= t <= b \/ b <= t <= a) f ->
  (forall t, a < t < b \/ b < t < a -> ex_derive f t) -> (forall t, a < t < b \/ b < t < a -> holds s (Derive f t - 0)) ->
  holds u (b - a) -> within (times s u) w && within (meet u EQ) w = true -> holds w (f b - f a).
Proof.
  assert (q : forall (f : R -> R) a b, a < b -> (forall t, a < t < b -> ex_derive f t) -> continuous_on (fun t => a <= t <= b) f ->
    exists c, f b - f a = Derive f c * (b - a) /\ a < c < b).
  { intros f a b h d k. assert (e : forall t, a < t < b -> derivable_pt_lim (fun y => f (Rmax a (Rmin b y))) t (Derive f t)).
    { intros t ht. apply is_derive_Reals, (is_derive_ext_loc f); [| now apply Derive_correct, d].
      apply (locally_interval _ t a b); [apply ht | apply ht |]. cbn. intros. now rewrite Rmin_right, Rmax_right by lra. }
    destruct (MVT _ id a b (fun t ht => exist _ _ (e t ht)) (fun t _ => derivable_pt_id t) h) as (t & ht & q); [| now intros; apply derivable_continuous, derivable_id |].
    - intros t _. apply continuity_pt_filterlim, extended; [lra | exact k].
    - exists t. split; [| exact ht]. rewrite derive_pt_id in q. unfold id in q. cbn in q.
      rewrite (Rmin_left b b), (Rmax_right a b), (Rmin_right b a), (Rmax_left a a) in q by lra. lra. }
  intros f a b s u w k d hs hu e. apply andb_prop in e. destruct e as [e1 e2].
  assert (p : forall c, a < c < b \/ b < c < a -> f b - f a = Derive f c * (b - a) -> holds w (f b - f a)).
  { intros c hc ->. apply (weaken _ _ _ e1), holds_times; [| exact hu]. rewrite <- (Rminus_0_r (Derive f c)). now apply hs. }
  destruct (Rtotal_order a b) as [h | [h | h]].
  - destruct (q f a b h) as (c & hq & hc); [intros; apply d; now left | apply (continuous_on_subset _ _ _ (fun t i => or_introl i) k) | apply (p c); [now left | exact hq]].
  - subst. apply (weaken _ _ _ e2). replace (f b - f b) with (b - b) by lra. apply both; [exact hu | now apply of_eq].
  - destruct (q f b a h) as (c & hq & hc); [intros; apply d; now right | apply (continuous_on_subset _ _ _ (fun t i => or_intror i) k) | apply (p c); [now right | lra]].
Qed.
Lemma smooth_on : forall (D : R -> Prop) (f : R -> R), (forall t, D t -> ex_derive f t) -> continuous_on D f.
Proof. intros D f d. apply continuous_on_forall. intros t h. now apply (ex_derive_continuous f), d. Qed.
Lemma slope : forall (f : R -> R) a b s u w,
  (forall t, a <= t <= b \/ b <= t <= a -> ex_derive f t) -> (forall t, a < t < b \/ b < t < a -> holds s (Derive f t - 0)) ->
  holds u (b - a) -> within (times s u) w && within (meet u EQ) w = true -> holds w (f b - f a).
Proof. intros f a b s u w d. apply slope_between; [now apply smooth_on | intros t h; apply d; lra]. Qed.
Lemma min_max : forall a b t, Rmin a b <= t <= Rmax a b <-> a <= t <= b \/ b <= t <= a.
Proof. intros. unfold Rmin, Rmax. destruct Rle_dec; lra. Qed.
(** Between a value that is not positive and one that is not negative a continuous function vanishes, strictly between if neither is 0. *)
Lemma intermediate : forall (f : R -> R) a b, continuous_on (fun t => a <= t <= b \/ b <= t <= a) f -> f a <= 0 -> 0 <= f b ->
  exists c, (a <= c <= b \/ b <= c <= a) /\ f c = 0 /\ (f a < 0 -> 0 < f b -> a < c < b \/ b < c < a).
Proof.
  intros f a b k ha hb. destruct (IVT_gen (fun t => f (Rmax (Rmin a b) (Rmin (Rmax a b) t))) a b 0) as (c & hc & e).
  - intro t. apply continuity_pt_filterlim, extended; [apply Rmin_Rmax | exact (continuous_on_subset _ _ _ (fun y => proj1 (min_max a b y)) k)].
  - rewrite !(Rmin_right (Rmax a b)), !(Rmax_right (Rmin a b)); unfold Rmin, Rmax; repeat destruct Rle_dec; lra.
  - rewrite (Rmin_right _ c), (Rmax_right _ c) in e by lra. apply min_max in hc. exists c. split; [exact hc | split; [exact e |]].
    intros u v. assert (c <> a /\ c <> b) by (split; intros ->; lra). lra.
Qed.
(** A function that is continuous from a to b has an integral from a to each t there, and is the derivative of this strictly between. *)
Lemma integral_there : forall (f : R -> R) a b, continuous_on (fun t => a <= t <= b \/ b <= t <= a) f -> exists F : R -> R,
  (forall t, a <= t <= b \/ b <= t <= a -> is_RInt f a t (F t)) /\ (forall t, continuous F t) /\ (forall t, a < t < b \/ b < t < a -> is_derive F t (f t)).
Proof.
  intros f a b k. set (g t := f (Rmax (Rmin a b) (Rmin (Rmax a b) t))).
  assert (same : forall t, a <= t <= b \/ b <= t <= a -> g t = f t) by (intros t h; apply min_max in h; unfold g; now rewrite (Rmin_right _ t), Rmax_right by lra).
  assert (c : forall t, continuous g t) by (intro t; apply extended; [apply Rmin_Rmax | exact (continuous_on_subset _ _ _ (fun y => proj1 (min_max a b y)) k)]).
  assert (i : forall t, is_RInt g a t (RInt g a t)) by (intro t; now apply (RInt_correct g), (ex_RInt_continuous g)).
  assert (d : forall t, is_derive (RInt g a) t (g t)) by (intro t; apply (is_derive_RInt _ _ a); [now apply filter_forall | apply c]).
  exists (RInt g a). split; [| split]; intros t.
  - intro h. apply (is_RInt_ext g); [| apply i]. intros y hy. apply same. assert (z := proj1 (min_max a t y)). lra.
  - apply (ex_derive_continuous (RInt g a)). now exists (g t).
  - intro h. rewrite <- same by lra. apply d.
Qed.
(** What F gains from a to b compared with the integral of f, by the sign of F' - f strictly between. *)
Lemma slope_integral : forall (F f : R -> R) a b s u w,
  continuous_on (fun t => a <= t <= b \/ b <= t <= a) F -> continuous_on (fun t => a <= t <= b \/ b <= t <= a) f ->
  (forall t, a < t < b \/ b < t < a -> ex_derive F t) -> (forall t, a < t < b \/ b < t < a -> holds s (Derive F t - f t)) ->
  holds u (b - a) -> within (times s u) w && within (meet u EQ) w = true -> holds w (F b - F a - RInt f a b).
Proof.
  intros F f a b s u w kF k d hs hu e. destruct (integral_there f a b k) as (G & i & c & dG).
  assert (z := is_RInt_unique _ _ _ _ (i a ltac:(lra))). rewrite RInt_point in z. rewrite (is_RInt_unique _ _ _ _ (i b ltac:(lra))).
  replace (F b - F a - G b) with ((F b - G b) - (F a - G a)) by (rewrite <- z; cbn; lra).
  assert (q : forall t, a < t < b \/ b < t < a -> is_derive (fun y : R => F y - G y) t (Derive F t - f t))
    by (intros t h; apply (is_derive_minus F G); [now apply Derive_correct, d | now apply dG]).
  apply (slope_between (fun y => F y - G y) a b s u w); [| intros t h; eexists; now apply q | | exact hu | exact e]; intros t h.
  - refine (filterlim_comp_2 _ _ Hierarchy.plus (kF t h) _ (filterlim_plus (F t) (opp (G t)))).
    apply (continuous_on_forall _ (fun y => opp (G y))) with (2 := h). intros y _. apply (continuous_opp G), c.
  - rewrite (is_derive_unique _ _ _ (q t h)), Rminus_0_r. now apply hs.
Qed.
(** The derivative of an integral whose ends move. *)
Lemma derivative_of_integral : forall (f a b : R -> R) x a' b', is_derive a x a' -> is_derive b x b' ->
  (forall t, a x <= t <= b x \/ b x <= t <= a x -> locally t (continuous f)) -> is_derive (fun y => RInt f (a y) (b y)) x (f (b x) * b' - f (a x) * a').
Proof.
  intros f a b x a' b' ha hb c. rewrite (Rmult_comm _ b'), (Rmult_comm _ a').
  assert (k : forall t, a x <= t <= b x \/ b x <= t <= a x -> continuous f t) by (intros t h; exact (locally_singleton _ _ (c t h))).
  assert (near : forall t, a x <= t <= b x \/ b x <= t <= a x -> exists e : posreal, ex_RInt f (t - e) (t + e)).
  { intros t h. destruct (c t h) as [e q]. exists (pos_div_2 e). assert (z := cond_pos e). apply (ex_RInt_continuous f).
    intros y hy. apply q. change (Rabs (y - t) < e). cbn in hy. apply min_max in hy. unfold Rabs. destruct Rcase_abs; lra. }
  apply (is_derive_RInt_bound_comp f (RInt f)); [| apply k; lra | apply k; lra | exact ha | exact hb].
  apply (filter_imp (fun z => ex_RInt f (fst z) (snd z))); [intros z h; now apply (RInt_correct f) |].
  apply (ex_RInt_locally f (a x) (b x)); [| apply near; lra | apply near; lra]. apply (ex_RInt_continuous f). intros t h. now apply k, min_max.
Qed.
Ltac between := intros; repeat match goal with H : _ \/ _ |- _ => destruct H end; repeat split; lra.
Ltac slope_sign z c := intros; first
  [ first [apply of_gt | apply of_ge | apply of_lt | apply of_le]; apply z; between
  | apply of_eq, is_derive_unique, z; between
  | apply of_ne; let e := fresh in intro e; eapply z; [.. | rewrite <- e; apply Derive_correct, c; between]; between ].
Ltac sloped z := first [exact z | (let h := fresh in assert (h := z); cbv beta in h; pushinr; exact h)].
(** [auto_derive] knows of exp and ln. *)
Ltac unroot_all := unfold tanh, sech, cosh, sinh, cbrt, Rpower.
Ltac differentiable := first
  [ auto_derive; repeat split; first [exact I | nz1 | pos]
  | unroot_all; auto_derive; repeat split; first [exact I | pos | solve [apply Rgt_not_eq; red; pos] | nz1] ].

(** Statements over numbers and propositions that are left as they are. *)
Ltac orders := repeat match goal with
  | x : R, y : R |- _ => lazymatch goal with
     | _ : x < y |- _ => fail | _ : y < x |- _ => fail | _ : x > y |- _ => fail | _ : y > x |- _ => fail
     | _ : x = y |- _ => fail | _ : y = x |- _ => fail
     | _ => destruct (Rtotal_order x y) as [? | [? | ?]] end end.
Ltac logic := intros; first [solve [tauto] | solve [intuition lra] | solve [intuition (subst; first [assumption | lra])]
  | match goal with |- context [?A -> _] => destruct (Classical_Prop.classic A); solve [intuition lra] end
  | (once orders; solve [intuition lra]) ].

(** The premises of a fact, one after the other. *)
Ltac premises z := repeat match type of z with
  | (?A -> ?B) => let h := fresh in assert (h : A) by (first [hyp | nz]); specialize (z h); clear h end.
Ltac give z v := premises z; specialize (z v).
Ltac same z := first [exact z | (cbv beta zeta in z |- *; exact z)
  | (cbn [INR Nat.add Nat.mul] in z |- *; exact z)
  | (rewrite ?plus_INR, ?mult_INR in z; cbn [INR] in z; rewrite ?plus_INR, ?mult_INR; cbn [INR]; exact z)
  | (revert z; apply eq_ind_r with (P := fun t => t -> _); tauto) | solve [intros; exact z] ].
Ltac by_any := match goal with H : forall _, _ |- _ => solve [apply H; at_hand | apply H; [at_hand | at_hand] | apply H] end.
Ltac pieces := repeat (cbv beta; intros; match goal with |- _ /\ _ => split end); intros; apart_all;
  first [at_hand | by_any | (cbv beta in *; first [at_hand | by_any])].
(** Comparisons of natural numbers, as those of the real numbers that they are. *)
Lemma eq_of_nat : forall a b : nat, a = b <-> INR a = INR b. Proof. intros a b. split; [now intros -> | apply INR_eq]. Qed.
Lemma le_of_nat : forall a b : nat, (a <= b)%nat <-> INR a <= INR b. Proof. intros a b. split; [apply le_INR | apply INR_le]. Qed.
Lemma lt_of_nat : forall a b : nat, (a < b)%nat <-> INR a < INR b. Proof. intros a b. split; [apply lt_INR | apply INR_lt]. Qed.
Ltac as_reals := unfold ge, gt; rewrite ?eq_of_nat, ?le_of_nat, ?lt_of_nat; pushinr.
Ltac finish z := first [exact z | (cbv beta zeta; exact z) | (cbv beta zeta; solve [pieces])
  | solve [cbv beta zeta; repeat match goal with |- _ /\ _ => split end; intros; apart_all; first [hyp | tauto | (apply z; hyp)]]
  | solve [cbv beta zeta; naturals; hyp] | solve [cbv beta zeta; as_reals; first [exact z | (cbn [INR]; exact z) | (revert z; unfold Rge, Rgt; tauto)]] | (generalize z; cbn; tauto)].
Lemma derive_is : forall (f : R -> R) x u v, is_derive f x u -> u = v -> is_derive f x v.
Proof. intros f x u v h <-. exact h. Qed.
Ltac in_exp := rewrite ?exp_Ropp; (field; repeat split; first [nz1 | (rewrite <- exp_Ropp; nz1)]).
Ltac by_root := match goal with |- context [sqrt ?u] => let h := fresh in assert (h : sqrt u ^ 2 = u) by square_of_root; field [h]; nz end.
Ltac derive k := first [ (auto_derive; [repeat split; first [nz1 | pos | exact I] | k; fld])
  | (evar_last; [auto_derive; [repeat split; first [nz1 | pos | exact I] | reflexivity] | k; fld])
  | (evar_last; [auto_derive; [repeat split; first [nz1 | pos | exact I] | reflexivity] | by_root])
  | (unroot_all; auto_derive; [repeat split; first [exact I | pos | solve [apply Rgt_not_eq; red; pos] | nz1] | in_exp]) ].
(** A divisor that is a multiple of what a fact compares with 0. *)
Ltac nz_by := match goal with H : ?p > 0 |- _ <> 0 =>
  let z := fresh in intro z; apply (Rgt_not_eq _ _ H); field_simplify_eq; [lra | nz] end.
Ltac at_point k := repeat match goal with H : forall _ : _, _ |- _ =>
  let z := fresh in assert (z := H k); clear H; try specialize (z ltac:(lra)) end; apart_all.
Ltac lead_nz z := first [exact z | (let h := fresh in intro h; apply z; first [rewrite <- h; ring | lra]) | nz1].
(** What [f] is in 1/x, P over Q, from [b] on; [z] says that the leading coefficient of the divisor is not 0. *)
Ltac limit_by l P Q b z := refine (l _ P Q _ b _ _ _ _ _); cbv beta;
  [ let k := fresh in let h := fresh in intros k h; at_point k; rewrite ?ln_exp;
    first [ring | (field; repeat split; first [nz1 | lra | nz_by]) | (pushinr; field; repeat split; first [nz1 | lra | nz_by])]
  | auto_derive; repeat split; first [exact I | nz1]
  | auto_derive; repeat split; first [exact I | nz1]
  | lead_nz z
  | first [ring | (field; repeat split; first [lead_nz z | nz1]) | (unfold Rdiv; ring)] ].

(** Intervals: what is linear is least at an end, and elsewhere only if it is constant. So a product is least at a corner: it is
    that least number only at a corner, or where one of its factors is 0; if both are, one of them is at its end. *)
Lemma line : forall k a b x m, a <= x <= b -> m <= a * k -> m <= b * k -> m <= x * k /\ (m = x * k -> x = a \/ x = b \/ k = 0).
Proof. intros k a b x m h u v. destruct (Rtotal_order k 0) as [n | [-> | p]]; [| split; [lra | tauto] |]; (split; [nra |]; intro e).
  - destruct (Req_dec x b); [tauto |]. exfalso; nra.
  - destruct (Req_dec x a); [tauto |]. exfalso; nra. Qed.
Lemma product_corner : forall m a b c d x y, a <= x <= b -> c <= y <= d -> m <= a * c -> m <= a * d -> m <= b * c -> m <= b * d ->
  m <= x * y /\ (m = x * y -> (x = a \/ x = b \/ y = 0) /\ (y = c \/ y = d \/ x = 0) /\ (x = 0 -> y = 0 -> x = a \/ y = d)).
Proof. intros m a b c d x y h g u v w z. assert (ay : m <= a * y /\ m <= b * y /\ m <= c * x /\ m <= d * x).
  { repeat split; rewrite Rmult_comm; [apply (line a c d) | apply (line b c d) | apply (line c a b) | apply (line d a b)]; lra. }
  destruct (line y a b x m h) as [l p], (line x c d y m g) as [_ q]; try tauto. split; [exact l |]. intro e.
  split; [tauto |]. split; [apply q; lra |]. intros -> ->. destruct (Req_dec 0 a); [tauto |]. right; nra. Qed.
Lemma even_power : forall a b x k, a <= x <= b -> 0 <= x ^ (2 * k) <= Rmax (Rabs a) (Rabs b) ^ (2 * k).
Proof. intros a b x k h. rewrite (pow_mult x), <- pow2_abs, <- pow_mult. split; [apply pow_le, Rabs_pos | apply pow_incr].
  split; [apply Rabs_pos |]. unfold Rmax, Rabs. repeat destruct Rcase_abs; destruct Rle_dec; lra. Qed.
Lemma bounded_by : forall s c x r, c <> 0 -> s = c * x + r -> x = (s - r) / c. Proof. intros s c x r h ->. now field. Qed.

(** cos and sin are a point of the unit circle. *)
Lemma unit_circle : forall u, cos u ^ 2 + sin u ^ 2 = 1.
Proof. intro u. rewrite <- (sin2_cos2 u). unfold Rsqr. ring. Qed.
Lemma within_one : forall u, -1 <= cos u <= 1 /\ -1 <= sin u <= 1.
Proof. split; [apply COS_bound | apply SIN_bound]. Qed.
Lemma sine_arc : forall u, (0 <= u <= PI -> 0 <= sin u) /\ (0 < u < PI -> 0 < sin u)
  /\ (- PI <= u <= 0 -> sin u <= 0) /\ (- PI < u < 0 -> sin u < 0).
Proof. intro u. assert (p := sin_neg u). repeat split; intro h; [apply sin_ge_0 | apply sin_gt_0 | assert (q := sin_ge_0 (- u)) | assert (q := sin_gt_0 (- u))]; lra. Qed.
Lemma cosine_arc : forall u, (- (PI / 2) <= u <= PI / 2 -> 0 <= cos u) /\ (- (PI / 2) < u < PI / 2 -> 0 < cos u)
  /\ (PI / 2 <= u <= 3 * (PI / 2) -> cos u <= 0) /\ (PI / 2 < u < 3 * (PI / 2) -> cos u < 0).
Proof. repeat split; intro h; [apply cos_ge_0 | apply cos_gt_0 | apply cos_le_0 | apply cos_lt_0]; lra. Qed.
(** A function that is 0 at 0 and rises up to x is positive at x. *)
Lemma risen : forall f g x, 0 < x -> f 0 = 0 -> (forall t, 0 <= t <= x -> derivable_pt_lim f t (g t)) ->
  (forall t, 0 < t < x -> 0 < g t) -> 0 < f x.
Proof. intros f g x h z d p. destruct (MVT_cor2 f g 0 x h d) as (c & e & hc). assert (q := p c hc). nra. Qed.
Lemma below_the_argument : forall u, 0 < u -> sin u < u.
Proof.
  assert (near : forall u, 0 < u < PI -> sin u < u).
  { intros u h. apply Rminus_gt_0_lt. apply (risen (fun t => t - sin t) (fun t => 1 - cos t)); [tauto | rewrite sin_0; lra | |].
    - intros t _. apply is_derive_Reals. auto_derive; [exact I | ring].
    - intros t ht. assert (a := sin_gt_0 t). assert (b := unit_circle t). assert (c := COS_bound t). nra. }
  intros u h. destruct (Rlt_dec u PI) as [l | l]; [apply near; lra |]. assert (a := SIN_bound u). assert (b := PI2_1). lra.
Qed.
Lemma below_the_tangent : forall u, 0 < u < PI -> u * cos u < sin u.
Proof.
  intros u h. apply Rminus_gt_0_lt. apply (risen (fun t => sin t - t * cos t) (fun t => t * sin t)); [tauto | rewrite sin_0; lra | |].
  - intros t _. apply is_derive_Reals. auto_derive; [exact I | ring].
  - intros t ht. assert (a := sin_gt_0 t). nra.
Qed.
(** One more time an argument. *)
Lemma multiple : forall k u, cos (INR (S k) * u) = cos (INR k * u) * cos u - sin (INR k * u) * sin u
  /\ sin (INR (S k) * u) = sin (INR k * u) * cos u + cos (INR k * u) * sin u.
Proof. intros. rewrite S_INR, Rmult_plus_distr_r, Rmult_1_l. split; [apply cos_plus | apply sin_plus]. Qed.

(** arctan and arcsin rise, and arccos falls, each strictly. *)
Lemma arcs_rise : forall a b, a < b -> atan a < atan b /\ (-1 <= a -> b <= 1 -> asin a < asin b /\ acos b < acos a).
Proof.
  intros a b h. split; [now apply atan_increasing |]. intros l r. rewrite !acos_asin by lra.
  enough (asin a < asin b) by lra. apply Rnot_le_lt. intro n. assert (p := asin_bound a). assert (q := asin_bound b).
  assert (z := sin_incr_1 (asin b) (asin a)). rewrite !sin_asin in z by lra. lra.
Qed.
(** An angle is the arc of its sine, or of its tangent: its cosine keeps it from the other half of the circle, the range from another turn. *)
Lemma arcsine_is : forall x y, sin y = x -> 0 <= cos y -> - (3 * (PI / 2)) < y < 3 * (PI / 2) -> asin x = y.
Proof. intros x y <- c h. destruct (cosine_arc y) as (_ & _ & _ & a), (cosine_arc (- y)) as (_ & _ & _ & b).
  rewrite cos_neg in b. apply asin_sin. split; apply Rnot_lt_le; intro; lra. Qed.
Lemma arctangent_is : forall x y, sin y = x * cos y -> 0 < cos y -> - (3 * (PI / 2)) < y < 3 * (PI / 2) -> atan x = y.
Proof. intros x y e c h. destruct (cosine_arc y) as (_ & _ & a & _), (cosine_arc (- y)) as (_ & _ & b & _). rewrite cos_neg in b.
  replace x with (tan y) by (unfold tan; rewrite e; field; lra). apply atan_tan. split; apply Rnot_le_lt; intro; lra. Qed.
(** The cosine and sine of an arc. *)
Lemma of_arctangent : forall x, cos (atan x) = 1 / sqrt (1 + x ^ 2) /\ sin (atan x) = x / sqrt (1 + x ^ 2).
Proof. intro x. rewrite cos_atan, sin_atan, <- !Rsqr_pow2. tauto. Qed.
Lemma of_arcsine : forall x, -1 <= x <= 1 -> cos (asin x) = sqrt (1 - x ^ 2) /\ sin (asin x) = x.
Proof. intros x h. rewrite cos_asin, sin_asin, <- Rsqr_pow2 by exact h. tauto. Qed.
Lemma slopes_of_arcs : forall x, is_derive atan x (/ (1 + x ^ 2)) /\ (-1 < x < 1 -> is_derive asin x (1 / sqrt (1 - x ^ 2))).
Proof. intro x. split; [| intro h; rewrite <- Rsqr_pow2]; apply is_derive_Reals; [apply derivable_pt_lim_atan |].
  exact (derive_pt_eq_1 _ _ _ _ (derive_pt_asin x h)). Qed.
