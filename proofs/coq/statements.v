(** What the claim files state, as propositions to be proved. Written by `carom export coq`:
    change the claim files, not this one. *)

From Carom Require Import vocabulary.

Definition eq01 : Prop :=
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (v1 v2 w1 w2 J : R),
  m1 * (w1 - v1) = - J ->
  m2 * (w2 - v2) = J ->
  m1 * v1 + m2 * v2 = m1 * w1 + m2 * w2.

Definition eq02 : Prop :=
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (v1 v2 w1 w2 : R),
  m1 * v1 + m2 * v2 = m1 * w1 + m2 * w2 ->
  v1 - v2 = - (w1 - w2) ->
  m1 * v1 ^ 2 / 2 + m2 * v2 ^ 2 / 2 = m1 * w1 ^ 2 / 2 + m2 * w2 ^ 2 / 2.

Definition eq03 : Prop :=
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (v1 v2 w1 w2 : R),
  w1 <> v1 ->
  m1 * v1 + m2 * v2 = m1 * w1 + m2 * w2 ->
  m1 * v1 ^ 2 / 2 + m2 * v2 ^ 2 / 2 = m1 * w1 ^ 2 / 2 + m2 * w2 ^ 2 / 2 ->
  v1 - v2 = - (w1 - w2).

Definition eq03_unguarded : Prop :=
  ~ (
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (v1 v2 w1 w2 : R),
  m1 * v1 + m2 * v2 = m1 * w1 + m2 * w2 ->
  m1 * v1 ^ 2 / 2 + m2 * v2 ^ 2 / 2 = m1 * w1 ^ 2 / 2 + m2 * w2 ^ 2 / 2 ->
  v1 - v2 = - (w1 - w2)).

Definition eq04 : Prop :=
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  forall (v1 v2 w1 w2 : R),
  v1 <> v2 ->
  m1 * v1 + m2 * v2 = m1 * w1 + m2 * w2 ->
  v2 - v1 <> 0 ->
  e = - ((w2 - w1) / (v2 - v1)) ->
  e = 1 <-> m1 * v1 ^ 2 / 2 + m2 * v2 ^ 2 / 2 = m1 * w1 ^ 2 / 2 + m2 * w2 ^ 2 / 2.

Definition eq05 : Prop :=
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  forall (v1 v2 w1 w2 : R),
  m1 * v1 + m2 * v2 = m1 * w1 + m2 * w2 ->
  w2 - w1 = - (e * (v2 - v1)) ->
  w1 = (m1 - e * m2) / (m1 + m2) * v1 + m2 * (1 + e) / (m1 + m2) * v2.

Definition eq05_defined : Prop :=
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  forall (v1 v2 w1 w2 : R),
  m1 * v1 + m2 * v2 = m1 * w1 + m2 * w2 ->
  w2 - w1 = - (e * (v2 - v1)) ->
  m1 + m2 <> 0.

Definition eq05_unique : Prop :=
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  forall (v1 v2 w1 w2 : R),
  m1 * v1 + m2 * v2 = m1 * w1 + m2 * w2 /\ w2 - w1 = - (e * (v2 - v1)) <-> w1 =
      (m1 - e * m2) / (m1 + m2) * v1 + m2 * (1 + e) / (m1 + m2) * v2 /\ w2 =
      m1 * (1 + e) / (m1 + m2) * v1 + (m2 - e * m1) / (m1 + m2) * v2.

Definition eq05_unique_defined : Prop :=
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  forall (v1 v2 w1 w2 : R),
  m1 + m2 <> 0.

Definition eq06 : Prop :=
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  forall (v1 v2 w1 w2 : R),
  m1 * v1 + m2 * v2 = m1 * w1 + m2 * w2 ->
  w2 - w1 = - (e * (v2 - v1)) ->
  w2 = m1 * (1 + e) / (m1 + m2) * v1 + (m2 - e * m1) / (m1 + m2) * v2.

Definition eq06_defined : Prop :=
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  forall (v1 v2 w1 w2 : R),
  m1 * v1 + m2 * v2 = m1 * w1 + m2 * w2 ->
  w2 - w1 = - (e * (v2 - v1)) ->
  m1 + m2 <> 0.

Definition eq07 : Prop :=
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  forall (v1 v2 w1 w2 : R),
  m1 * v1 + m2 * v2 = m1 * w1 + m2 * w2 ->
  w2 - w1 = - (e * (v2 - v1)) ->
  let x := m1 / m2 in
  [[w1]; [w2]] = mat_scale (1 / (m1 + m2)) (mat_mul [[m1 - e * m2; m2 * (1 + e)]; [m1 * (1 + e); m2 - e *
      m1]] [[v1]; [v2]]) /\
  [[w1]; [w2]] = mat_scale (1 / (x + 1)) (mat_mul [[x - e; 1 + e]; [x * (1 + e); 1 - e * x]] [[v1]; [v2]]).

Definition eq07_defined : Prop :=
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  forall (v1 v2 w1 w2 : R),
  m1 * v1 + m2 * v2 = m1 * w1 + m2 * w2 ->
  w2 - w1 = - (e * (v2 - v1)) ->
  m1 + m2 <> 0 /\
  m1 / m2 + 1 <> 0 /\
  m2 <> 0.

Definition eq08 : Prop :=
  forall (m1 m2 v1 : R), m1 > 0 -> m2 > 0 -> v1 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  let w2 := m1 * (1 + e) / (m1 + m2) * v1 in
  (m2 * w2 ^ 2 / 2) / (m1 * v1 ^ 2 / 2) = (1 + e) ^ 2 * m1 * m2 / (m1 + m2) ^ 2.

Definition eq08_defined : Prop :=
  forall (m1 m2 v1 : R), m1 > 0 -> m2 > 0 -> v1 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  m1 <> 0 /\
  v1 <> 0 /\
  m1 + m2 <> 0.

Definition eq09 : Prop :=
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  let x := m1 / m2 in
  (1 + e) ^ 2 * m1 * m2 / (m1 + m2) ^ 2 = (1 + e) ^ 2 * x / (1 + x) ^ 2.

Definition eq09_defined : Prop :=
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  m1 + m2 <> 0 /\
  1 + m1 / m2 <> 0 /\
  m2 <> 0.

Definition eq10 : Prop :=
  forall (x : R), x > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  let share := (1 + e) ^ 2 * x / (1 + x) ^ 2 in
  (share = 1 <-> x - (1 + e) * sqrt x + 1 = 0) /\
  (share = 1 <-> e = 1 /\ x = 1).

Definition eq10_defined : Prop :=
  forall (x : R), x > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  1 + x <> 0 /\
  0 <= x.

Definition eq10_extracted : Prop :=
  ~ (
  forall (x : R), x > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  (1 + e) ^ 2 * x / (1 + x) ^ 2 = 1 <-> x - (1 + e) * x + 1 = 0).

Definition eq10_roots : Prop :=
  forall (e y s : R),
  s ^ 2 = (e + 3) * (e - 1) ->
  y ^ 2 - (1 + e) * y + 1 = (y - (1 + e + s) / 2) * (y - (1 + e - s) / 2) /\
  ((y - (1 + e + s) / 2) * (y - (1 + e - s) / 2) = 0 <-> y = (1 + e + s) / 2 \/ y = (1 + e - s) / 2).

Definition eq11 : Prop :=
  forall (e : R), 0 <= e <= 1 ->
  let f := fun (x : R) => (1 + e) ^ 2 * x / (1 + x) ^ 2 in
  1 > 0 /\
  f 1 = (1 + e) ^ 2 / 4 /\
  (forall (x : R), x > 0 -> f x <= (1 + e) ^ 2 / 4 /\ (f x = (1 + e) ^ 2 / 4 -> x = 1)).

Definition eq11_defined : Prop :=
  forall (e : R), 0 <= e <= 1 ->
  (forall (x : R), x > 0 -> 1 + x <> 0).

Definition eq12 : Prop :=
  forall (m1 m2 mu v1 : R), m1 > 0 -> m2 > 0 -> mu > 0 -> v1 > 0 ->
  forall (e1 e2 : R), 0 <= e1 <= 1 -> 0 <= e2 <= 1 ->
  forall (v_mu w2 : R),
  v_mu = m1 * (1 + e1) / (m1 + mu) * v1 ->
  w2 = mu * (1 + e2) / (mu + m2) * v_mu ->
  w2 = (1 + e1) * (1 + e2) * m1 * mu / ((m1 + mu) * (mu + m2)) * v1 /\
  m2 * w2 ^ 2 / 2 = (1 + e1) ^ 2 * (1 + e2) ^ 2 * m1 * m2 * mu ^ 2 / ((m1 + mu) ^ 2 * (mu + m2) ^ 2) * (m1 *
      v1 ^ 2 / 2).

Definition eq12_defined : Prop :=
  forall (m1 m2 mu v1 : R), m1 > 0 -> m2 > 0 -> mu > 0 -> v1 > 0 ->
  forall (e1 e2 : R), 0 <= e1 <= 1 -> 0 <= e2 <= 1 ->
  forall (v_mu w2 : R),
  v_mu = m1 * (1 + e1) / (m1 + mu) * v1 ->
  w2 = mu * (1 + e2) / (mu + m2) * v_mu ->
  m1 + mu <> 0 /\
  mu + m2 <> 0.

Definition eq13 : Prop :=
  forall (m1 m2 mu : R), m1 > 0 -> m2 > 0 -> mu > 0 ->
  forall (e1 e2 : R), 0 <= e1 <= 1 -> 0 <= e2 <= 1 ->
  forall (v1 : R), v1 > 0 ->
  let v_mu := m1 * (1 + e1) / (m1 + mu) * v1 in
  let v_2 := mu * (1 + e2) / (mu + m2) * v_mu in
  (m2 * v_2 ^ 2 / 2) / (m1 * v1 ^ 2 / 2) =
      (1 + e1) ^ 2 * (1 + e2) ^ 2 * m1 * m2 * mu ^ 2 / ((m1 + mu) ^ 2 * (mu + m2) ^ 2).

Definition eq13_defined : Prop :=
  forall (m1 m2 mu : R), m1 > 0 -> m2 > 0 -> mu > 0 ->
  forall (e1 e2 : R), 0 <= e1 <= 1 -> 0 <= e2 <= 1 ->
  forall (v1 : R), v1 > 0 ->
  m1 <> 0 /\
  v1 <> 0 /\
  mu + m2 <> 0 /\
  m1 + mu <> 0.

Definition eq14 : Prop :=
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e1 e2 : R), 0 <= e1 <= 1 -> 0 <= e2 <= 1 ->
  let f := fun (mu : R) => (1 + e1) ^ 2 * (1 + e2) ^ 2 * m1 * m2 * mu ^ 2 / ((m1 + mu) ^ 2 * (mu + m2) ^ 2) in
  sqrt (m1 * m2) > 0 /\
  f (sqrt (m1 * m2)) = (1 + e1) ^ 2 * (1 + e2) ^ 2 * m1 * m2 / (sqrt m1 + sqrt m2) ^ 4 /\
  (forall (mu : R), mu > 0 -> f mu <= (1 + e1) ^ 2 * (1 + e2) ^ 2 * m1 * m2 / (sqrt m1 + sqrt m2) ^ 4 /\
      (f mu = (1 + e1) ^ 2 * (1 + e2) ^ 2 * m1 * m2 / (sqrt m1 + sqrt m2) ^ 4 -> mu = sqrt (m1 * m2))).

Definition eq14_defined : Prop :=
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e1 e2 : R), 0 <= e1 <= 1 -> 0 <= e2 <= 1 ->
  0 <= m1 * m2 /\
  sqrt m1 + sqrt m2 <> 0 /\
  0 <= m1 /\
  0 <= m2 /\
  (forall (mu : R), mu > 0 -> m1 + mu <> 0) /\
  (forall (mu : R), mu > 0 -> mu + m2 <> 0).

Definition eq15 : Prop :=
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  let eta2 := (1 + e) ^ 2 * m1 * m2 / (m1 + m2) ^ 2 in
  let eta3 := (1 + e) ^ 4 * m1 * m2 / (sqrt m1 + sqrt m2) ^ 4 in
  (eta3 >= eta2 <-> e >= (sqrt m1 + sqrt m2) ^ 2 / (m1 + m2) - 1) /\
  (sqrt m1 + sqrt m2) ^ 2 / (m1 + m2) - 1 = 2 * sqrt (m1 * m2) / (m1 + m2).

Definition eq15_defined : Prop :=
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  sqrt m1 + sqrt m2 <> 0 /\
  0 <= m1 /\
  0 <= m2 /\
  m1 + m2 <> 0 /\
  0 <= m1 * m2.

Definition eq16 : Prop :=
  forall (m1 m2 mu1 mu2 v1 : R), m1 > 0 -> m2 > 0 -> mu1 > 0 -> mu2 > 0 -> v1 > 0 ->
  forall (e1 e2 e3 : R), 0 <= e1 <= 1 -> 0 <= e2 <= 1 -> 0 <= e3 <= 1 ->
  let u1 := m1 * (1 + e1) / (m1 + mu1) * v1 in
  let u2 := mu1 * (1 + e2) / (mu1 + mu2) * u1 in
  let u3 := mu2 * (1 + e3) / (mu2 + m2) * u2 in
  (m2 * u3 ^ 2 / 2) / (m1 * v1 ^ 2 / 2) =
      (1 + e1) ^ 2 * (1 + e2) ^ 2 * (1 + e3) ^ 2 * m1 * m2 * mu1 ^ 2 * mu2 ^ 2 / ((m1 + mu1) ^ 2 * (mu1 +
      mu2) ^ 2 * (mu2 + m2) ^ 2).

Definition eq16_defined : Prop :=
  forall (m1 m2 mu1 mu2 v1 : R), m1 > 0 -> m2 > 0 -> mu1 > 0 -> mu2 > 0 -> v1 > 0 ->
  forall (e1 e2 e3 : R), 0 <= e1 <= 1 -> 0 <= e2 <= 1 -> 0 <= e3 <= 1 ->
  m1 <> 0 /\
  v1 <> 0 /\
  mu2 + m2 <> 0 /\
  mu1 + mu2 <> 0 /\
  m1 + mu1 <> 0.

Definition eq17 : Prop :=
  forall (m1 m2 mu1 mu2 : R), m1 > 0 -> m2 > 0 -> mu1 > 0 -> mu2 > 0 ->
  forall (e1 e2 e3 : R), 0 <= e1 <= 1 -> 0 <= e2 <= 1 -> 0 <= e3 <= 1 ->
  let k := (1 + e1) ^ 2 * (1 + e2) ^ 2 * (1 + e3) ^ 2 * m1 * m2 in
  let eta := fun (a : R) (b : R) => k * a ^ 2 * b ^ 2 / ((m1 + a) ^ 2 * (a + b) ^ 2 * (b + m2) ^ 2) in
  let best := k / (cbrt m1 + cbrt m2) ^ 6 in
  eta (cbrt (m1 ^ 2 * m2)) (cbrt (m1 * m2 ^ 2)) = best /\
  eta mu1 mu2 <= best /\
  (eta mu1 mu2 = best <-> mu1 = cbrt (m1 ^ 2 * m2) /\ mu2 = cbrt (m1 * m2 ^ 2)).

Definition eq17_defined : Prop :=
  forall (m1 m2 mu1 mu2 : R), m1 > 0 -> m2 > 0 -> mu1 > 0 -> mu2 > 0 ->
  forall (e1 e2 e3 : R), 0 <= e1 <= 1 -> 0 <= e2 <= 1 -> 0 <= e3 <= 1 ->
  m1 + cbrt (m1 ^ 2 * m2) <> 0 /\
  cbrt (m1 ^ 2 * m2) + cbrt (m1 * m2 ^ 2) <> 0 /\
  cbrt (m1 * m2 ^ 2) + m2 <> 0 /\
  m1 ^ 2 * m2 > 0 /\
  m1 * m2 ^ 2 > 0 /\
  cbrt m1 + cbrt m2 <> 0 /\
  m1 > 0 /\
  m2 > 0 /\
  m1 + mu1 <> 0 /\
  mu1 + mu2 <> 0 /\
  mu2 + m2 <> 0.

Definition eq18 : Prop :=
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  let eta3 := (1 + e) ^ 4 * m1 * m2 / (sqrt m1 + sqrt m2) ^ 4 in
  let eta4 := (1 + e) ^ 6 * m1 * m2 / (cbrt m1 + cbrt m2) ^ 6 in
  eta4 >= eta3 <-> e >= (cbrt m1 + cbrt m2) ^ 3 / (sqrt m1 + sqrt m2) ^ 2 - 1.

Definition eq18_defined : Prop :=
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  cbrt m1 + cbrt m2 <> 0 /\
  m1 > 0 /\
  m2 > 0 /\
  sqrt m1 + sqrt m2 <> 0 /\
  0 <= m1 /\
  0 <= m2.

Definition eq18_extracted : Prop :=
  ~ (
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  let eta2 := (1 + e) ^ 2 * m1 * m2 / (m1 + m2) ^ 2 in
  let eta3 := (1 + e) ^ 4 * m1 * m2 / (sqrt m1 + sqrt m2) ^ 4 in
  sqrt (eta3 / eta2) >= 1 <-> e >= (cbrt m1 + cbrt m2) ^ 3 / (sqrt m1 + sqrt m2) ^ 2 - 1).

Definition eq19 : Prop :=
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  forall (n : nat), (n >= 1)%nat ->
  let S := fun (k : nat) => Rpower m1 (1 / INR k) + Rpower m2 (1 / INR k) in
  let eta := fun (k : nat) => (1 + e) ^ (2 * k) * m1 * m2 / S k ^ (2 * k) in
  let L := S (n + 1)%nat ^ (n + 1) / S n ^ n - 1 in
  eta (n + 1)%nat >= eta n <-> L <= e.

Definition eq19_defined : Prop :=
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  forall (n : nat), (n >= 1)%nat ->
  Rpower m1 (1 / INR (n + 1)) + Rpower m2 (1 / INR (n + 1)) <> 0 /\
  m1 > 0 /\
  INR (n + 1) <> 0 /\
  m2 > 0 /\
  Rpower m1 (1 / INR n) + Rpower m2 (1 / INR n) <> 0 /\
  INR n <> 0.

Definition eq20 : Prop :=
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (n : nat), (n >= 1)%nat ->
  forall (i : nat), (i >= 1)%nat ->
  (i <= n)%nat ->
  let mu := fun (k : R) => Rpower m1 ((INR n + 1 - k) / INR (n + 1)) * Rpower m2 (k / INR (n + 1)) in
  mu (INR i) = sqrt (mu (INR i - 1) * mu (INR (i + 1))) /\
  mu 0 = m1 /\
  mu (INR (n + 1)) = m2.

Definition eq20_defined : Prop :=
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (n : nat), (n >= 1)%nat ->
  forall (i : nat), (i >= 1)%nat ->
  (i <= n)%nat ->
  m1 > 0 /\
  INR (n + 1) <> 0 /\
  m2 > 0 /\
  0 <= (Rpower m1 ((INR n + 1 - (INR i - 1)) / INR (n + 1)) * Rpower m2 ((INR i - 1) / INR (n + 1))) *
      (Rpower m1 ((INR n + 1 - INR (i + 1)) / INR (n + 1)) * Rpower m2 (INR (i + 1) / INR (n + 1))).

Definition eq20_converse : Prop :=
  forall (mu : nat -> R), (forall k : nat, mu k > 0) ->
  forall (n : nat),
  (forall (k : nat), mu (k + 1)%nat ^ 2 = mu k * mu (k + 2)%nat) ->
  mu (n + 1)%nat / mu n = mu 1%nat / mu 0%nat.

Definition eq20_converse_defined : Prop :=
  forall (mu : nat -> R), (forall k : nat, mu k > 0) ->
  forall (n : nat),
  (forall (k : nat), mu (k + 1)%nat ^ 2 = mu k * mu (k + 2)%nat) ->
  mu n <> 0 /\
  mu 0%nat <> 0.

Definition eq21 : Prop :=
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (n : nat), (n >= 1)%nat ->
  forall (i : nat),
  (i <= n)%nat ->
  let mu := fun (k : nat) => Rpower m1 ((INR n + 1 - INR k) / INR (n + 1)) * Rpower m2 (INR k / INR (n +
      1)) in
  let x := Rpower (m1 / m2) (1 / INR (n + 1)) in
  mu i / mu (i + 1)%nat = x /\
  mu 0%nat = m1 /\
  mu (n + 1)%nat = m2.

Definition eq21_defined : Prop :=
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (n : nat), (n >= 1)%nat ->
  forall (i : nat),
  (i <= n)%nat ->
  m1 > 0 /\
  INR (n + 1) <> 0 /\
  m2 > 0 /\
  m1 / m2 > 0 /\
  m2 <> 0.

Definition eq22 : Prop :=
  forall (x : R), x > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  forall (v1 : R), v1 > 0 ->
  forall u : nat -> R, u 0%nat = v1 ->
  (forall k : nat, u (k + 1)%nat = x * (1 + e) / (x + 1) * u k) ->
  forall (i : nat),
  (x - e) / (x + 1) * u i = (x * (1 + e)) ^ i * (x - e) / (x + 1) ^ (i + 1) * v1.

Definition eq22_defined : Prop :=
  forall (x : R), x > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  forall (v1 : R), v1 > 0 ->
  forall (i : nat),
  forall u : nat -> R, u 0%nat = v1 ->
  (forall k : nat, u (k + 1)%nat = x * (1 + e) / (x + 1) * u k) ->
  (forall k : nat, x + 1 <> 0) /\
  x + 1 <> 0.

Definition eq23 : Prop :=
  forall (m1 mu1 v1 : R), m1 > 0 -> mu1 > 0 -> v1 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  let x := m1 / mu1 in
  (m1 - e * mu1) / (m1 + mu1) * v1 = (x - e) / (x + 1) * v1.

Definition eq23_defined : Prop :=
  forall (m1 mu1 v1 : R), m1 > 0 -> mu1 > 0 -> v1 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  m1 + mu1 <> 0 /\
  m1 / mu1 + 1 <> 0 /\
  mu1 <> 0.

Definition eq24 : Prop :=
  forall (x : R), x > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  forall (v1 : R), v1 > 0 ->
  forall u : nat -> R, u 0%nat = v1 ->
  (forall k : nat, u (k + 1)%nat = x * (1 + e) / (x + 1) * u k) ->
  forall (n : nat),
  u (n + 1)%nat = (x * (1 + e) / (x + 1)) ^ (n + 1) * v1.

Definition eq24_defined : Prop :=
  forall (x : R), x > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  forall (v1 : R), v1 > 0 ->
  forall (n : nat),
  forall u : nat -> R, u 0%nat = v1 ->
  (forall k : nat, u (k + 1)%nat = x * (1 + e) / (x + 1) * u k) ->
  (forall k : nat, x + 1 <> 0) /\
  x + 1 <> 0.

Definition eq25 : Prop :=
  forall (m1 m2 v1 : R), m1 > 0 -> m2 > 0 -> v1 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  forall (n : nat),
  let x := Rpower (m1 / m2) (1 / INR (n + 1)) in
  let w2 := (x * (1 + e) / (x + 1)) ^ (n + 1) * v1 in
  (m2 * w2 ^ 2 / 2) / (m1 * v1 ^ 2 / 2) =
      (1 + e) ^ (2 * (n + 1)) * m1 * m2 / (Rpower m1 (1 / INR (n + 1)) + Rpower m2 (1 / INR (n + 1))) ^ (2 *
      (n + 1)).

Definition eq25_defined : Prop :=
  forall (m1 m2 v1 : R), m1 > 0 -> m2 > 0 -> v1 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  forall (n : nat),
  m1 <> 0 /\
  v1 <> 0 /\
  Rpower (m1 / m2) (1 / INR (n + 1)) + 1 <> 0 /\
  m1 / m2 > 0 /\
  m2 <> 0 /\
  INR (n + 1) <> 0 /\
  Rpower m1 (1 / INR (n + 1)) + Rpower m2 (1 / INR (n + 1)) <> 0 /\
  m1 > 0 /\
  m2 > 0.

Definition p_elastic : Prop :=
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (n : nat), (n >= 1)%nat ->
  let S := fun (k : nat) => Rpower m1 (1 / INR k) + Rpower m2 (1 / INR k) in
  let eta := fun (k : nat) => 2 ^ (2 * k) * m1 * m2 / S k ^ (2 * k) in
  eta (n + 1)%nat >= eta n /\
  (eta (n + 1)%nat > eta n <-> m1 <> m2).

Definition p_elastic_defined : Prop :=
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (n : nat), (n >= 1)%nat ->
  Rpower m1 (1 / INR (n + 1)) + Rpower m2 (1 / INR (n + 1)) <> 0 /\
  m1 > 0 /\
  INR (n + 1) <> 0 /\
  m2 > 0 /\
  Rpower m1 (1 / INR n) + Rpower m2 (1 / INR n) <> 0 /\
  INR n <> 0.

Definition p_final : Prop :=
  ~ (
  forall (x v1 : R), x > 0 -> v1 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  forall (i : nat),
  let u := fun (i : nat) => (x * (1 + e) / (x + 1)) ^ i * v1 in
  let w := fun (i : nat) => (x - e) / (x + 1) * u i in
  w i <= w (i + 1)%nat).

Definition p_final_repaired : Prop :=
  forall (x v1 : R), x > 0 -> v1 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  forall (i : nat),
  let u := fun (i : nat) => (x * (1 + e) / (x + 1)) ^ i * v1 in
  let w := fun (i : nat) => (x - e) / (x + 1) * u i in
  (w i <= w (i + 1)%nat <-> x <= e \/ x * e >= 1) /\
  w i <= u (i + 1)%nat.

Definition p_final_repaired_defined : Prop :=
  forall (x v1 : R), x > 0 -> v1 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  forall (i : nat),
  x + 1 <> 0.

Definition p_frame : Prop :=
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  forall (v1 v2 w1 w2 : R),
  m1 * v1 + m2 * v2 = m1 * w1 + m2 * w2 ->
  w2 - w1 = - (e * (v2 - v1)) ->
  forall (s : R),
  (w2 + s) - (w1 + s) = - (e * ((v2 + s) - (v1 + s))) /\
  [[w1 + s]; [w2 + s]] = mat_scale (1 / (m1 + m2)) (mat_mul [[m1 - e * m2; m2 * (1 + e)]; [m1 * (1 + e); m2 -
      e * m1]] [[v1 + s]; [v2 + s]]).

Definition p_frame_defined : Prop :=
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  forall (v1 v2 w1 w2 : R),
  forall (s : R),
  m1 * v1 + m2 * v2 = m1 * w1 + m2 * w2 ->
  w2 - w1 = - (e * (v2 - v1)) ->
  m1 + m2 <> 0.

Definition p_frame_energy : Prop :=
  exists (e : R), 0 <= e <= 1 /\ exists (m1 m2 : R), m1 > 0 /\ m2 > 0 /\ exists (v1 v2 s : R), m1 + m2 <> 0 /\
      m1 * v1 ^ 2 + m2 * v2 ^ 2 <> 0 /\ m1 * (v1 + s) ^ 2 + m2 * (v2 + s) ^ 2 <> 0 /\
      m1 * v1 ^ 2 + m2 * v2 ^ 2 <> 0 /\ m1 * (v1 + s) ^ 2 + m2 * (v2 + s) ^ 2 <> 0 /\
      m1 * m2 * (1 - e ^ 2) * (v1 - v2) ^ 2 / (m1 + m2) / (m1 * v1 ^ 2 + m2 * v2 ^ 2) <>
      m1 * m2 * (1 - e ^ 2) * (v1 - v2) ^ 2 / (m1 + m2) / (m1 * (v1 + s) ^ 2 + m2 * (v2 + s) ^ 2).

Definition p_full : Prop :=
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  (1 + e) ^ 2 * m1 * m2 / (m1 + m2) ^ 2 = 1 <-> e = 1 /\ m1 = m2.

Definition p_full_defined : Prop :=
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  m1 + m2 <> 0.

Definition p_grow : Prop :=
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  let L1 := (sqrt m1 + sqrt m2) ^ 2 / (m1 + m2) - 1 in
  let L2 := (cbrt m1 + cbrt m2) ^ 3 / (sqrt m1 + sqrt m2) ^ 2 - 1 in
  L2 >= L1 /\
  (L2 = L1 <-> m1 = m2).

Definition p_grow_defined : Prop :=
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  sqrt m1 + sqrt m2 <> 0 /\
  m1 > 0 /\
  m2 > 0 /\
  0 <= m1 /\
  0 <= m2 /\
  m1 + m2 <> 0.

Definition p_indep : Prop :=
  forall (n : nat),
  forall (mu nu : nat -> R), (forall k : nat, mu k > 0) -> (forall k : nat, nu k > 0) ->
  forall (e f : nat -> R), (forall k : nat, 0 <= e k <= 1) -> (forall k : nat, 0 <= f k <= 1) ->
  mu 0%nat = nu 0%nat /\ mu (n + 1)%nat = nu (n + 1)%nat ->
  let chain_mu_e := product_over 0 n (fun i : nat => (1 + e i) * mu i / (mu i + mu (i + 1)%nat)) in
  let chain_nu_e := product_over 0 n (fun i : nat => (1 + e i) * nu i / (nu i + nu (i + 1)%nat)) in
  let chain_mu_f := product_over 0 n (fun i : nat => (1 + f i) * mu i / (mu i + mu (i + 1)%nat)) in
  let chain_nu_f := product_over 0 n (fun i : nat => (1 + f i) * nu i / (nu i + nu (i + 1)%nat)) in
  chain_mu_e ^ 2 / chain_nu_e ^ 2 = chain_mu_f ^ 2 / chain_nu_f ^ 2 /\
  (chain_mu_e ^ 2 <= chain_nu_e ^ 2 <-> chain_mu_f ^ 2 <= chain_nu_f ^ 2).

Definition p_indep_defined : Prop :=
  forall (n : nat),
  forall (mu nu : nat -> R), (forall k : nat, mu k > 0) -> (forall k : nat, nu k > 0) ->
  forall (e f : nat -> R), (forall k : nat, 0 <= e k <= 1) -> (forall k : nat, 0 <= f k <= 1) ->
  mu 0%nat = nu 0%nat /\ mu (n + 1)%nat = nu (n + 1)%nat ->
  product_over 0 n (fun i_1 : nat => (1 + e i_1) * nu i_1 / (nu i_1 + nu (i_1 + 1)%nat)) <> 0 /\
  (forall i : nat, (0 <= i <= n)%nat -> mu i + mu (i + 1)%nat <> 0) /\
  (forall i_1 : nat, (0 <= i_1 <= n)%nat -> nu i_1 + nu (i_1 + 1)%nat <> 0) /\
  product_over 0 n (fun i_3 : nat => (1 + f i_3) * nu i_3 / (nu i_3 + nu (i_3 + 1)%nat)) <> 0 /\
  (forall i_2 : nat, (0 <= i_2 <= n)%nat -> mu i_2 + mu (i_2 + 1)%nat <> 0) /\
  (forall i_3 : nat, (0 <= i_3 <= n)%nat -> nu i_3 + nu (i_3 + 1)%nat <> 0).

Definition p_inelastic : Prop :=
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (n : nat), (n >= 1)%nat ->
  let S := fun (k : nat) => Rpower m1 (1 / INR k) + Rpower m2 (1 / INR k) in
  let eta := fun (k : nat) => m1 * m2 / S k ^ (2 * k) in
  eta (n + 1)%nat < eta n.

Definition p_inelastic_defined : Prop :=
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (n : nat), (n >= 1)%nat ->
  Rpower m1 (1 / INR (n + 1)) + Rpower m2 (1 / INR (n + 1)) <> 0 /\
  m1 > 0 /\
  INR (n + 1) <> 0 /\
  m2 > 0 /\
  Rpower m1 (1 / INR n) + Rpower m2 (1 / INR n) <> 0 /\
  INR n <> 0.

Definition p_loss : Prop :=
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  forall (v1 v2 w1 w2 : R),
  m1 * v1 + m2 * v2 = m1 * w1 + m2 * w2 ->
  w2 - w1 = - (e * (v2 - v1)) ->
  let loss := m1 * v1 ^ 2 / 2 + m2 * v2 ^ 2 / 2 - m1 * w1 ^ 2 / 2 - m2 * w2 ^ 2 / 2 in
  loss = m1 * m2 * (1 - e ^ 2) * (v1 - v2) ^ 2 / (2 * (m1 + m2)) /\
  loss >= 0 /\
  (loss = 0 <-> e = 1 \/ v1 = v2).

Definition p_loss_defined : Prop :=
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  forall (v1 v2 w1 w2 : R),
  m1 * v1 + m2 * v2 = m1 * w1 + m2 * w2 ->
  w2 - w1 = - (e * (v2 - v1)) ->
  m1 + m2 <> 0.

Definition p_order : Prop :=
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  forall (v1 v2 w1 w2 : R),
  m1 * v1 + m2 * v2 = m1 * w1 + m2 * w2 ->
  w2 - w1 = - (e * (v2 - v1)) ->
  v1 >= v2 ->
  w1 <= w2.

Definition p_rest : Prop :=
  forall (x v1 : R), x > 0 -> v1 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  forall (i : nat),
  ((x - e) / (x + 1) * v1 = 0 <-> x = e) /\
  ((x * (1 + e)) ^ i * (x - e) / (x + 1) ^ (i + 1) * v1 = 0 <-> x = e).

Definition p_rest_defined : Prop :=
  forall (x v1 : R), x > 0 -> v1 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  forall (i : nat),
  x + 1 <> 0.

Definition p_stop : Prop :=
  forall (m1 m2 v1 : R), m1 > 0 -> m2 > 0 -> v1 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  let w1 := (m1 - e * m2) / (m1 + m2) * v1 in
  let eta := (1 + e) ^ 2 * m1 * m2 / (m1 + m2) ^ 2 in
  (w1 = 0 <-> m1 = e * m2) /\
  (m1 = e * m2 -> eta = e) /\
  e <= (1 + e) ^ 2 / 4 /\
  (e = (1 + e) ^ 2 / 4 <-> e = 1).

Definition p_stop_defined : Prop :=
  forall (m1 m2 v1 : R), m1 > 0 -> m2 > 0 -> v1 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  m1 + m2 <> 0.

Definition p_two : Prop :=
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  let L2 := (cbrt m1 + cbrt m2) ^ 3 / (sqrt m1 + sqrt m2) ^ 2 - 1 in
  let eta2 := (1 + e) ^ 2 * m1 * m2 / (m1 + m2) ^ 2 in
  let eta3 := (1 + e) ^ 4 * m1 * m2 / (sqrt m1 + sqrt m2) ^ 4 in
  let eta4 := (1 + e) ^ 6 * m1 * m2 / (cbrt m1 + cbrt m2) ^ 6 in
  e >= L2 ->
  eta4 >= eta3 /\
  eta4 >= eta2.

Definition p_two_defined : Prop :=
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  e >= (cbrt m1 + cbrt m2) ^ 3 / (sqrt m1 + sqrt m2) ^ 2 - 1 ->
  cbrt m1 + cbrt m2 <> 0 /\
  m1 > 0 /\
  m2 > 0 /\
  sqrt m1 + sqrt m2 <> 0 /\
  0 <= m1 /\
  0 <= m2 /\
  m1 + m2 <> 0.

Definition p_two_converse : Prop :=
  ~ (
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  let L2 := (cbrt m1 + cbrt m2) ^ 3 / (sqrt m1 + sqrt m2) ^ 2 - 1 in
  let eta2 := (1 + e) ^ 2 * m1 * m2 / (m1 + m2) ^ 2 in
  let eta4 := (1 + e) ^ 6 * m1 * m2 / (cbrt m1 + cbrt m2) ^ 6 in
  eta4 >= eta2 -> e >= L2).

Definition u1 : Prop :=
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  forall (v1 v2 w1 w2 : R),
  m1 * v1 + m2 * v2 = m1 * w1 + m2 * w2 ->
  w2 - w1 = - (e * (v2 - v1)) ->
  w2 = w1 - e * (v2 - v1) /\
  m1 * v1 + m2 * v2 = (m1 + m2) * w1 - e * m2 * (v2 - v1).

Definition u2 : Prop :=
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  forall (v1 : R),
  let w2 := m1 * (1 + e) / (m1 + m2) * v1 in
  let K1 := m1 * v1 ^ 2 / 2 in
  m2 * w2 ^ 2 / 2 = m2 / 2 * (m1 * (1 + e) / (m1 + m2)) ^ 2 * v1 ^ 2 /\
  m2 * w2 ^ 2 / 2 = (1 + e) ^ 2 * m1 * m2 / (m1 + m2) ^ 2 * K1.

Definition u2_defined : Prop :=
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  forall (v1 : R),
  m1 + m2 <> 0.

Definition u3 : Prop :=
  forall (x : R), x > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  is_derive (fun x : R => (1 + e) ^ 2 * x / (1 + x) ^ 2) x ((1 + e) ^ 2 * ((1 + x) ^ 2 - 2 * x * (1 + x)) /
      (1 + x) ^ 4) /\
  is_derive (fun x : R => (1 + e) ^ 2 * x / (1 + x) ^ 2) x ((1 + e) ^ 2 * (1 - x) / (1 + x) ^ 3).

Definition u3_defined : Prop :=
  forall (x : R), x > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  ex_derive (fun x : R => (1 + e) ^ 2 * x / (1 + x) ^ 2) x /\
  1 + x <> 0.

Definition u4 : Prop :=
  forall (m1 mu : R), m1 > 0 -> mu > 0 ->
  forall (e1 : R), 0 <= e1 <= 1 ->
  forall (v1 v w1 w : R),
  m1 * v1 + mu * v = m1 * w1 + mu * w ->
  w - w1 = - (e1 * (v - v1)) ->
  [[w1]; [w]] = mat_scale (1 / (m1 + mu)) (mat_mul [[m1 - e1 * mu; mu * (1 + e1)]; [m1 * (1 + e1); mu - e1 *
      m1]] [[v1]; [v]]).

Definition u4_defined : Prop :=
  forall (m1 mu : R), m1 > 0 -> mu > 0 ->
  forall (e1 : R), 0 <= e1 <= 1 ->
  forall (v1 v w1 w : R),
  m1 * v1 + mu * v = m1 * w1 + mu * w ->
  w - w1 = - (e1 * (v - v1)) ->
  m1 + mu <> 0.

Definition u5 : Prop :=
  forall (m1 m2 mu : R), m1 > 0 -> m2 > 0 -> mu > 0 ->
  forall (e1 e2 : R), 0 <= e1 <= 1 -> 0 <= e2 <= 1 ->
  let k1 := 2 * (1 + e1) ^ 2 * (1 + e2) ^ 2 * m1 * m2 in
  is_derive (fun mu : R => (1 + e1) ^ 2 * (1 + e2) ^ 2 * m1 * m2 * mu ^ 2 / ((m1 + mu) ^ 2 * (mu +
      m2) ^ 2)) mu (k1 * mu * ((m1 + mu) * (mu + m2) - mu * (m1 + m2 + 2 * mu)) / ((m1 + mu) ^ 3 * (mu +
      m2) ^ 3)) /\
  is_derive (fun mu : R => (1 + e1) ^ 2 * (1 + e2) ^ 2 * m1 * m2 * mu ^ 2 / ((m1 + mu) ^ 2 * (mu +
      m2) ^ 2)) mu (k1 * mu * (m1 * m2 - mu ^ 2) / ((m1 + mu) ^ 3 * (mu + m2) ^ 3)).

Definition u5_defined : Prop :=
  forall (m1 m2 mu : R), m1 > 0 -> m2 > 0 -> mu > 0 ->
  forall (e1 e2 : R), 0 <= e1 <= 1 -> 0 <= e2 <= 1 ->
  ex_derive (fun mu : R => (1 + e1) ^ 2 * (1 + e2) ^ 2 * m1 * m2 * mu ^ 2 / ((m1 + mu) ^ 2 * (mu +
      m2) ^ 2)) mu /\
  m1 + mu <> 0 /\
  mu + m2 <> 0.

Definition u5_extracted : Prop :=
  ~ (
  forall (m2 mu x : R), m2 > 0 -> mu > 0 -> x > 0 ->
  forall (e1 e2 : R), 0 <= e1 <= 1 -> 0 <= e2 <= 1 ->
  let m1 := x * m2 in
  let k1 := 2 * (1 + e1) ^ 2 * (1 + e2) ^ 2 * m1 * m2 in
  is_derive (fun x : R => (1 + e1) ^ 2 * (1 + e2) ^ 2 * (x * m2) * m2 * mu ^ 2 / ((x * m2 + mu) ^ 2 * (mu +
      m2) ^ 2)) x (k1 * mu * (m1 * m2 - mu ^ 2) / ((m1 + mu) ^ 3 * (mu + m2) ^ 3))).

Definition u6 : Prop :=
  forall (m1 m2 mu : R), m1 > 0 -> m2 > 0 -> mu > 0 ->
  forall (e1 e2 : R), 0 <= e1 <= 1 -> 0 <= e2 <= 1 ->
  let k1 := 2 * (1 + e1) ^ 2 * (1 + e2) ^ 2 * m1 * m2 in
  let second := fun (t : R) => k1 * ((m1 * m2 - 3 * t ^ 2) * (m1 + t) * (t + m2) - 3 * t * (m1 * m2 - t ^ 2) *
      (m1 + m2 + 2 * t)) / ((m1 + t) ^ 4 * (t + m2) ^ 4) in
  is_derive_n (fun mu : R => (1 + e1) ^ 2 * (1 + e2) ^ 2 * m1 * m2 * mu ^ 2 / ((m1 + mu) ^ 2 * (mu +
      m2) ^ 2)) 2 mu (second mu) /\
  second (sqrt (m1 * m2)) < 0.

Definition u6_defined : Prop :=
  forall (m1 m2 mu : R), m1 > 0 -> m2 > 0 -> mu > 0 ->
  forall (e1 e2 : R), 0 <= e1 <= 1 -> 0 <= e2 <= 1 ->
  ex_derive_n (fun mu : R => (1 + e1) ^ 2 * (1 + e2) ^ 2 * m1 * m2 * mu ^ 2 / ((m1 + mu) ^ 2 * (mu +
      m2) ^ 2)) 2 mu /\
  m1 + mu <> 0 /\
  mu + m2 <> 0 /\
  m1 + sqrt (m1 * m2) <> 0 /\
  sqrt (m1 * m2) + m2 <> 0 /\
  0 <= m1 * m2.

Definition u7 : Prop :=
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  let eta2 := fun (e : R) => (1 + e) ^ 2 * m1 * m2 / (m1 + m2) ^ 2 in
  let eta3 := fun (e : R) => (1 + e) ^ 4 * m1 * m2 / (sqrt m1 + sqrt m2) ^ 4 in
  eta2 1 = 4 * m1 * m2 / (m1 + m2) ^ 2 /\
  eta3 1 = 16 * m1 * m2 / (sqrt m1 + sqrt m2) ^ 4 /\
  eta3 1 / eta2 1 = 4 * (m1 + m2) ^ 2 / (sqrt m1 + sqrt m2) ^ 4.

Definition u7_defined : Prop :=
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  m1 + m2 <> 0 /\
  sqrt m1 + sqrt m2 <> 0 /\
  0 <= m1 /\
  0 <= m2 /\
  INR (1 + 1) <> 0 /\
  m1 <> 0 /\
  m2 <> 0.

Definition u8 : Prop :=
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  let ratio := 4 * (m1 + m2) ^ 2 / (sqrt m1 + sqrt m2) ^ 4 in
  sqrt ratio - 1 = ((sqrt m1 - sqrt m2) / (sqrt m1 + sqrt m2)) ^ 2 /\
  sqrt ratio - 1 >= 0.

Definition u8_defined : Prop :=
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  0 <= 4 * (m1 + m2) ^ 2 / (sqrt m1 + sqrt m2) ^ 4 /\
  sqrt m1 + sqrt m2 <> 0 /\
  0 <= m1 /\
  0 <= m2.

Definition u8_extracted : Prop :=
  ~ (
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  let ratio := 4 * (m1 + m2) ^ 2 / (sqrt m1 + sqrt m2) ^ 4 in
  ratio - 1 = ((sqrt m1 - sqrt m2) / (sqrt m1 + sqrt m2)) ^ 2).

Definition u9 : Prop :=
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  let ratio := (m1 + m2) ^ 2 / (sqrt m1 + sqrt m2) ^ 4 in
  sqrt ratio - 1 = - (2 * sqrt (m1 * m2) / (sqrt m1 + sqrt m2) ^ 2) /\
  sqrt ratio - 1 <= 0.

Definition u9_defined : Prop :=
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  0 <= (m1 + m2) ^ 2 / (sqrt m1 + sqrt m2) ^ 4 /\
  sqrt m1 + sqrt m2 <> 0 /\
  0 <= m1 /\
  0 <= m2 /\
  0 <= m1 * m2.

Definition u9_extracted : Prop :=
  ~ (
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  let ratio := (m1 + m2) ^ 2 / (sqrt m1 + sqrt m2) ^ 4 in
  ratio - 1 = - (2 * sqrt (m1 * m2) / (sqrt m1 + sqrt m2) ^ 2)).

Definition u10 : Prop :=
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e e1 e2 : R), 0 <= e <= 1 -> 0 <= e1 <= 1 -> 0 <= e2 <= 1 ->
  let eta2 := (1 + e) ^ 2 * m1 * m2 / (m1 + m2) ^ 2 in
  let eta3 := (1 + e1) ^ 2 * (1 + e2) ^ 2 * m1 * m2 / (sqrt m1 + sqrt m2) ^ 4 in
  eta3 >= eta2 <-> (1 + e1) * (1 + e2) * (m1 + m2) >= (1 + e) * (sqrt m1 + sqrt m2) ^ 2.

Definition u10_defined : Prop :=
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e e1 e2 : R), 0 <= e <= 1 -> 0 <= e1 <= 1 -> 0 <= e2 <= 1 ->
  sqrt m1 + sqrt m2 <> 0 /\
  0 <= m1 /\
  0 <= m2 /\
  m1 + m2 <> 0.

Definition u11 : Prop :=
  forall (m1 m2 mu1 mu2 : R), m1 > 0 -> m2 > 0 -> mu1 > 0 -> mu2 > 0 ->
  forall (e1 e2 e3 : R), 0 <= e1 <= 1 -> 0 <= e2 <= 1 -> 0 <= e3 <= 1 ->
  (is_derive (fun mu1 : R => (1 + e1) ^ 2 * (1 + e2) ^ 2 * (1 + e3) ^ 2 * m1 * m2 * mu1 ^ 2 * mu2 ^ 2 / ((m1 +
      mu1) ^ 2 * (mu1 + mu2) ^ 2 * (mu2 + m2) ^ 2)) mu1 0 <-> m1 * mu1 + m1 * mu2 + mu1 ^ 2 + mu1 * mu2 =
      m1 * mu1 + 2 * mu1 ^ 2 + mu1 * mu2) /\
  (is_derive (fun mu1 : R => (1 + e1) ^ 2 * (1 + e2) ^ 2 * (1 + e3) ^ 2 * m1 * m2 * mu1 ^ 2 * mu2 ^ 2 / ((m1 +
      mu1) ^ 2 * (mu1 + mu2) ^ 2 * (mu2 + m2) ^ 2)) mu1 0 <-> mu1 = sqrt (m1 * mu2)) /\
  (is_derive (fun mu2 : R => (1 + e1) ^ 2 * (1 + e2) ^ 2 * (1 + e3) ^ 2 * m1 * m2 * mu1 ^ 2 * mu2 ^ 2 / ((m1 +
      mu1) ^ 2 * (mu1 + mu2) ^ 2 * (mu2 + m2) ^ 2)) mu2 0 <-> mu1 * mu2 + mu1 * m2 + mu2 ^ 2 + mu2 * m2 =
      mu1 * mu2 + 2 * mu2 ^ 2 + mu2 * m2) /\
  (is_derive (fun mu2 : R => (1 + e1) ^ 2 * (1 + e2) ^ 2 * (1 + e3) ^ 2 * m1 * m2 * mu1 ^ 2 * mu2 ^ 2 / ((m1 +
      mu1) ^ 2 * (mu1 + mu2) ^ 2 * (mu2 + m2) ^ 2)) mu2 0 <-> mu2 = sqrt (mu1 * m2)).

Definition u11_defined : Prop :=
  forall (m1 m2 mu1 mu2 : R), m1 > 0 -> m2 > 0 -> mu1 > 0 -> mu2 > 0 ->
  forall (e1 e2 e3 : R), 0 <= e1 <= 1 -> 0 <= e2 <= 1 -> 0 <= e3 <= 1 ->
  ex_derive (fun mu1 : R => (1 + e1) ^ 2 * (1 + e2) ^ 2 * (1 + e3) ^ 2 * m1 * m2 * mu1 ^ 2 * mu2 ^ 2 / ((m1 +
      mu1) ^ 2 * (mu1 + mu2) ^ 2 * (mu2 + m2) ^ 2)) mu1 /\
  m1 + mu1 <> 0 /\
  mu1 + mu2 <> 0 /\
  mu2 + m2 <> 0 /\
  0 <= m1 * mu2 /\
  ex_derive (fun mu2 : R => (1 + e1) ^ 2 * (1 + e2) ^ 2 * (1 + e3) ^ 2 * m1 * m2 * mu1 ^ 2 * mu2 ^ 2 / ((m1 +
      mu1) ^ 2 * (mu1 + mu2) ^ 2 * (mu2 + m2) ^ 2)) mu2 /\
  0 <= mu1 * m2.

Definition u12 : Prop :=
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  let eta3 := (1 + e) ^ 4 * m1 * m2 / (sqrt m1 + sqrt m2) ^ 4 in
  let eta4 := (1 + e) ^ 6 * m1 * m2 / (cbrt m1 + cbrt m2) ^ 6 in
  eta4 / eta3 = (1 + e) ^ 2 * (sqrt m1 + sqrt m2) ^ 4 / (cbrt m1 + cbrt m2) ^ 6 /\
  (eta4 >= eta3 <-> (1 + e) * (sqrt m1 + sqrt m2) ^ 2 >= (cbrt m1 + cbrt m2) ^ 3).

Definition u12_defined : Prop :=
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  1 + e <> 0 /\
  m1 <> 0 /\
  m2 <> 0 /\
  cbrt m1 + cbrt m2 <> 0 /\
  m1 > 0 /\
  m2 > 0 /\
  sqrt m1 + sqrt m2 <> 0 /\
  0 <= m1 /\
  0 <= m2.

Definition u13 : Prop :=
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  let x := m1 / m2 in
  let first := (sqrt m1 + sqrt m2) ^ 2 / (m1 + m2) in
  let second := (cbrt m1 + cbrt m2) ^ 3 / (sqrt m1 + sqrt m2) ^ 2 in
  second / first = (cbrt m1 + cbrt m2) ^ 3 * (m1 + m2) / (sqrt m1 + sqrt m2) ^ 4 /\
  second / first = (cbrt x + 1) ^ 3 * (x + 1) / (sqrt x + 1) ^ 4 /\
  second / first >= 1 /\
  (second / first = 1 <-> m1 = m2).

Definition u13_defined : Prop :=
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  sqrt m1 + sqrt m2 <> 0 /\
  m1 > 0 /\
  m2 > 0 /\
  0 <= m1 /\
  0 <= m2 /\
  m1 + m2 <> 0 /\
  sqrt (m1 / m2) + 1 <> 0 /\
  m1 / m2 > 0 /\
  m2 <> 0 /\
  0 <= m1 / m2.

Definition b_best : Prop :=
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  forall (n : nat), (n >= 1)%nat ->
  let S := fun (k : nat) => Rpower m1 (1 / INR k) + Rpower m2 (1 / INR k) in
  let eta := fun (k : nat) => (1 + e) ^ (2 * k) * m1 * m2 / S k ^ (2 * k) in
  let L := fun (k : nat) => S (k + 1)%nat ^ (k + 1) / S k ^ k - 1 in
  (eta (n + 2)%nat >= eta (n + 1)%nat -> eta (n + 1)%nat >= eta n) /\
  (eta (n + 1)%nat >= eta n <-> L n <= e) /\
  (m1 = m2 -> L n = 1).

Definition b_best_defined : Prop :=
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  forall (n : nat), (n >= 1)%nat ->
  Rpower m1 (1 / INR (n + 2)) + Rpower m2 (1 / INR (n + 2)) <> 0 /\
  m1 > 0 /\
  INR (n + 2) <> 0 /\
  m2 > 0 /\
  Rpower m1 (1 / INR (n + 1)) + Rpower m2 (1 / INR (n + 1)) <> 0 /\
  INR (n + 1) <> 0 /\
  Rpower m1 (1 / INR n) + Rpower m2 (1 / INR n) <> 0 /\
  INR n <> 0.

Definition b_best_after : Prop :=
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  forall (N : nat), (N >= 1)%nat ->
  forall (j : nat),
  let S := fun (k : nat) => Rpower m1 (1 / INR k) + Rpower m2 (1 / INR k) in
  let L := fun (k : nat) => S (k + 1)%nat ^ (k + 1) / S k ^ k - 1 in
  e < L N ->
  e < L (N + j)%nat.

Definition b_best_after_defined : Prop :=
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  forall (N : nat), (N >= 1)%nat ->
  forall (j : nat),
  e < (Rpower m1 (1 / INR (N + 1)) + Rpower m2 (1 / INR (N + 1))) ^ (N + 1) / (Rpower m1 (1 / INR N) +
      Rpower m2 (1 / INR N)) ^ N - 1 ->
  Rpower m1 (1 / INR (N + j)) + Rpower m2 (1 / INR (N + j)) <> 0 /\
  m1 > 0 /\
  INR ((N + j) + 1) <> 0 /\
  m2 > 0 /\
  INR (N + j) <> 0.

Definition b_best_elastic : Prop :=
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (n : nat), (n >= 1)%nat ->
  let S := fun (k : nat) => Rpower m1 (1 / INR k) + Rpower m2 (1 / INR k) in
  let L := S (n + 1)%nat ^ (n + 1) / S n ^ n - 1 in
  (m1 <> m2 -> L < 1) /\
  (m1 = m2 -> L = 1).

Definition b_best_elastic_defined : Prop :=
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (n : nat), (n >= 1)%nat ->
  Rpower m1 (1 / INR n) + Rpower m2 (1 / INR n) <> 0 /\
  m1 > 0 /\
  INR (n + 1) <> 0 /\
  m2 > 0 /\
  INR n <> 0.

Definition b_best_finite : Prop :=
  forall (m2 : R), m2 > 0 ->
  forall (r : R), r >= 1 ->
  forall (e : R), 0 <= e < 1 ->
  forall (n : nat), (n >= 1)%nat ->
  let m1 := r * m2 in
  let S := fun (k : nat) => Rpower m1 (1 / INR k) + Rpower m2 (1 / INR k) in
  let L := S (n + 1)%nat ^ (n + 1) / S n ^ n - 1 in
  INR n * (1 - e) > 2 * (r - 1) ^ 2 ->
  e < L.

Definition b_best_finite_defined : Prop :=
  forall (m2 : R), m2 > 0 ->
  forall (r : R), r >= 1 ->
  forall (e : R), 0 <= e < 1 ->
  forall (n : nat), (n >= 1)%nat ->
  INR n * (1 - e) > 2 * (r - 1) ^ 2 ->
  Rpower (r * m2) (1 / INR n) + Rpower m2 (1 / INR n) <> 0 /\
  r * m2 > 0 /\
  INR (n + 1) <> 0 /\
  m2 > 0 /\
  INR n <> 0.

Definition b_budget : Prop :=
  forall (mu : nat -> R), (forall k : nat, mu k > 0) ->
  forall (e : nat -> R), (forall k : nat, 0 <= e k <= 1) ->
  forall (v1 : R),
  forall (n : nat),
  forall u : nat -> R, u 0%nat = v1 ->
  (forall k : nat, u (k + 1)%nat = mu k * (1 + e k) / (mu k + mu (k + 1)%nat) * u k) ->
  let keep := fun (k : nat) => (mu k - e k * mu (k + 1)%nat) / (mu k + mu (k + 1)%nat) * u k in
  let loss := fun (k : nat) => mu k * mu (k + 1)%nat * (1 - e k ^ 2) * u k ^ 2 / (2 * (mu k + mu (k +
      1)%nat)) in
  sum_over 0 n (fun k : nat => mu k * keep k) + mu (n + 1)%nat * u (n + 1)%nat = mu 0%nat * v1 /\
  mu 0%nat * v1 ^ 2 / 2 = sum_over 0 n (fun k : nat => mu k * keep k ^ 2 / 2) + mu (n + 1)%nat * u (n +
      1)%nat ^ 2 / 2 + sum_over 0 n (fun k : nat => loss k).

Definition b_budget_defined : Prop :=
  forall (mu : nat -> R), (forall k : nat, mu k > 0) ->
  forall (e : nat -> R), (forall k : nat, 0 <= e k <= 1) ->
  forall (v1 : R),
  forall (n : nat),
  forall u : nat -> R, u 0%nat = v1 ->
  (forall k : nat, u (k + 1)%nat = mu k * (1 + e k) / (mu k + mu (k + 1)%nat) * u k) ->
  (forall k : nat, mu k + mu (k + 1)%nat <> 0) /\
  (forall k_1 : nat, (0 <= k_1 <= n)%nat -> mu k_1 + mu (k_1 + 1)%nat <> 0) /\
  (forall k_2 : nat, (0 <= k_2 <= n)%nat -> mu k_2 + mu (k_2 + 1)%nat <> 0) /\
  (forall k_3 : nat, (0 <= k_3 <= n)%nat -> mu k_3 + mu (k_3 + 1)%nat <> 0).

Definition b_closed : Prop :=
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  forall (n : nat), (n >= 1)%nat ->
  let d := ln (m1 / m2) / 2 in
  let S := fun (k : nat) => Rpower m1 (1 / INR k) + Rpower m2 (1 / INR k) in
  (1 + e) ^ (2 * (n + 1)) * m1 * m2 / S (n + 1)%nat ^ (2 * (n + 1)) =
      ((1 + e) / 2 * sech (d / INR (n + 1))) ^ (2 * (n + 1)) /\
  S (n + 1)%nat ^ (n + 1) / S n ^ n - 1 = 2 * cosh (d / INR (n + 1)) ^ (n + 1) / cosh (d / INR n) ^ n - 1.

Definition b_closed_defined : Prop :=
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  forall (n : nat), (n >= 1)%nat ->
  Rpower m1 (1 / INR (n + 1)) + Rpower m2 (1 / INR (n + 1)) <> 0 /\
  m1 > 0 /\
  INR (n + 1) <> 0 /\
  m2 > 0 /\
  m1 / m2 > 0 /\
  m2 <> 0 /\
  Rpower m1 (1 / INR n) + Rpower m2 (1 / INR n) <> 0 /\
  INR n <> 0 /\
  cosh ((ln (m1 / m2) / 2) / INR n) <> 0.

Definition b_final : Prop :=
  forall (x : R), x > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  forall (n : nat), (n >= 1)%nat ->
  let L := (1 + x) ^ (n + 1) / (1 + Rpower x (INR (n + 1) / INR n)) ^ n - 1 in
  e >= L ->
  x <= e \/ x * e >= 1.

Definition b_global : Prop :=
  forall (mu : nat -> R), (forall k : nat, mu k > 0) ->
  forall (e : nat -> R), (forall k : nat, 0 <= e k <= 1) ->
  forall (n : nat), (n >= 1)%nat ->
  let N := (n + 1)%nat in
  let m1 := mu 0%nat in
  let m2 := mu (n + 1)%nat in
  let eta := product_over 0 n (fun i : nat => (1 + e i) ^ 2) * m1 * m2 *
      product_over 1 n (fun i : nat => mu i) ^ 2 / product_over 0 n (fun i : nat => mu i + mu (i +
      1)%nat) ^ 2 in
  let best := product_over 0 n (fun i : nat => (1 + e i) ^ 2) * m1 * m2 / (Rpower m1 (1 / INR N) +
      Rpower m2 (1 / INR N)) ^ (2 * N) in
  eta <= best.

Definition b_global_defined : Prop :=
  forall (mu : nat -> R), (forall k : nat, mu k > 0) ->
  forall (e : nat -> R), (forall k : nat, 0 <= e k <= 1) ->
  forall (n : nat), (n >= 1)%nat ->
  product_over 0 n (fun i : nat => mu i + mu (i + 1)%nat) <> 0 /\
  Rpower (mu 0%nat) (1 / INR (n + 1)) + Rpower (mu (n + 1)%nat) (1 / INR (n + 1)) <> 0 /\
  mu 0%nat > 0 /\
  INR (n + 1) <> 0 /\
  mu (n + 1)%nat > 0.

Definition b_global_unique : Prop :=
  forall (mu : nat -> R), (forall k : nat, mu k > 0) ->
  forall (j k : nat),
  let n := (j + k)%nat in
  let N := (n + 1)%nat in
  let m1 := mu 0%nat in
  let m2 := mu (n + 1)%nat in
  forall (e : nat -> R), (forall k : nat, 0 <= e k <= 1) ->
  let eta := product_over 0 n (fun i : nat => (1 + e i) ^ 2) * m1 * m2 *
      product_over 1 n (fun i : nat => mu i) ^ 2 / product_over 0 n (fun i : nat => mu i + mu (i +
      1)%nat) ^ 2 in
  let best := product_over 0 n (fun i : nat => (1 + e i) ^ 2) * m1 * m2 / (Rpower m1 (1 / INR N) +
      Rpower m2 (1 / INR N)) ^ (2 * N) in
  mu (j + 1)%nat <> mu j * Rpower (m2 / m1) (1 / INR N) ->
  eta < best.

Definition b_global_unique_defined : Prop :=
  forall (mu : nat -> R), (forall k : nat, mu k > 0) ->
  forall (j k : nat),
  forall (e : nat -> R), (forall k : nat, 0 <= e k <= 1) ->
  mu (j + 1)%nat <> mu j * Rpower (mu ((j + k) + 1)%nat / mu 0%nat) (1 / INR ((j + k) + 1)) ->
  product_over 0 (j + k) (fun i : nat => mu i + mu (i + 1)%nat) <> 0 /\
  Rpower (mu 0%nat) (1 / INR ((j + k) + 1)) + Rpower (mu ((j + k) + 1)%nat) (1 / INR ((j + k) + 1)) <> 0 /\
  mu 0%nat > 0 /\
  INR ((j + k) + 1) <> 0 /\
  mu ((j + k) + 1)%nat > 0.

Definition b_grow : Prop :=
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (n : nat), (n >= 1)%nat ->
  let S := fun (k : nat) => Rpower m1 (1 / INR k) + Rpower m2 (1 / INR k) in
  let L := fun (k : nat) => S (k + 1)%nat ^ (k + 1) / S k ^ k - 1 in
  L (n + 1)%nat >= L n /\
  (m1 <> m2 -> L (n + 1)%nat > L n).

Definition b_grow_defined : Prop :=
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (n : nat), (n >= 1)%nat ->
  Rpower m1 (1 / INR (n + 1)) + Rpower m2 (1 / INR (n + 1)) <> 0 /\
  m1 > 0 /\
  INR ((n + 1) + 1) <> 0 /\
  m2 > 0 /\
  INR (n + 1) <> 0 /\
  Rpower m1 (1 / INR n) + Rpower m2 (1 / INR n) <> 0 /\
  INR n <> 0.

Definition b_grow_bounded : Prop :=
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (n : nat), (n >= 1)%nat ->
  let S := fun (k : nat) => Rpower m1 (1 / INR k) + Rpower m2 (1 / INR k) in
  S (n + 1)%nat ^ (n + 1) <= 2 * S n ^ n /\
  (m1 <> m2 -> S (n + 1)%nat ^ (n + 1) < 2 * S n ^ n).

Definition b_grow_bounded_defined : Prop :=
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (n : nat), (n >= 1)%nat ->
  m1 > 0 /\
  INR (n + 1) <> 0 /\
  m2 > 0 /\
  INR n <> 0.

Definition b_grow_limit : Prop :=
  forall (m2 r : R), m2 > 0 -> r > 0 ->
  forall (n : nat), (n >= 1)%nat ->
  is_lim_seq (fun n : nat => (Rpower (r * m2) (1 / INR (n + 1)) + Rpower m2 (1 / INR (n + 1))) ^ (n + 1) /
      (Rpower (r * m2) (1 / INR n) + Rpower m2 (1 / INR n)) ^ n - 1) 1.

Definition b_grow_limit_defined : Prop :=
  forall (m2 r : R), m2 > 0 -> r > 0 ->
  forall (n : nat), (n >= 1)%nat ->
  Rpower (r * m2) (1 / INR n) + Rpower m2 (1 / INR n) <> 0 /\
  r * m2 > 0 /\
  INR (n + 1) <> 0 /\
  m2 > 0 /\
  INR n <> 0.

Definition b_limit : Prop :=
  forall (m2 r : R), m2 > 0 -> r > 0 ->
  forall (n : nat), (n >= 1)%nat ->
  is_lim_seq (fun n : nat => 4 ^ n * (r * m2) * m2 / (Rpower (r * m2) (1 / INR n) + Rpower m2 (1 /
      INR n)) ^ (2 * n)) 1.

Definition b_limit_defined : Prop :=
  forall (m2 r : R), m2 > 0 -> r > 0 ->
  forall (n : nat), (n >= 1)%nat ->
  Rpower (r * m2) (1 / INR n) + Rpower m2 (1 / INR n) <> 0 /\
  r * m2 > 0 /\
  INR n <> 0 /\
  m2 > 0.

Definition b_limit_inelastic : Prop :=
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e < 1 ->
  forall (n : nat), (n >= 1)%nat ->
  is_lim_seq (fun n : nat => (1 + e) ^ (2 * n) * m1 * m2 / (Rpower m1 (1 / INR n) + Rpower m2 (1 /
      INR n)) ^ (2 * n)) 0.

Definition b_limit_inelastic_defined : Prop :=
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e < 1 ->
  forall (n : nat), (n >= 1)%nat ->
  Rpower m1 (1 / INR n) + Rpower m2 (1 / INR n) <> 0 /\
  m1 > 0 /\
  INR n <> 0 /\
  m2 > 0.

Definition b_matrix : Prop :=
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  let M := mat_scale (1 / (m1 + m2)) [[m1 - e * m2; m2 * (1 + e)]; [m1 * (1 + e); m2 - e * m1]] in
  let I := [[1; 0]; [0; 1]] in
  det2 M = - e /\
  det2 (mat_add M (mat_scale (- 1) I)) = 0 /\
  det2 (mat_add M (mat_scale e I)) = 0 /\
  mat_mul (mat_add M (mat_scale (- 1) I)) (mat_add M (mat_scale e I)) = mat_scale 0 I /\
  mat_mul M [[1]; [1]] = [[1]; [1]] /\
  mat_mul M [[- m2]; [m1]] = mat_scale (- 1) (mat_scale e [[- m2]; [m1]]).

Definition b_matrix_defined : Prop :=
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  m1 + m2 <> 0.

Definition b_positive : Prop :=
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (n : nat), (n >= 1)%nat ->
  let S := fun (k : nat) => Rpower m1 (1 / INR k) + Rpower m2 (1 / INR k) in
  S (n + 1)%nat ^ (n + 1) > S n ^ n.

Definition b_positive_defined : Prop :=
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (n : nat), (n >= 1)%nat ->
  m1 > 0 /\
  INR (n + 1) <> 0 /\
  m2 > 0 /\
  INR n <> 0.

Definition b_power : Prop :=
  forall (w : R), w > 1 ->
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (N : R), N > 0 ->
  let u := ln w / 2 in
  let e := 2 * cosh u / exp (u * tanh u) - 1 in
  let eta := Rpower (1 + e) (2 * N) * m1 * m2 / Rpower (Rpower m1 (1 / N) + Rpower m2 (1 / N)) (2 * N) in
  u * tanh u - ln (cosh u) = ln (2 / (1 + e)) /\
  eta <= Rpower (m1 / m2) (tanh u) /\
  eta <= Rpower (m2 / m1) (tanh u).

Definition b_power_defined : Prop :=
  forall (w : R), w > 1 ->
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (N : R), N > 0 ->
  w > 0 /\
  cosh (ln w / 2) > 0 /\
  2 / (1 + (2 * cosh (ln w / 2) / exp ((ln w / 2) * tanh (ln w / 2)) - 1)) > 0 /\
  1 + (2 * cosh (ln w / 2) / exp ((ln w / 2) * tanh (ln w / 2)) - 1) <> 0 /\
  exp ((ln w / 2) * tanh (ln w / 2)) <> 0 /\
  1 + (2 * cosh (ln w / 2) / exp ((ln w / 2) * tanh (ln w / 2)) - 1) > 0 /\
  Rpower m1 (1 / N) + Rpower m2 (1 / N) > 0 /\
  m1 > 0 /\
  N <> 0 /\
  m2 > 0 /\
  m1 / m2 > 0 /\
  m2 <> 0 /\
  m2 / m1 > 0 /\
  m1 <> 0.

Definition b_power_attained : Prop :=
  forall (w : R), w > 1 ->
  forall (m2 N : R), m2 > 0 -> N > 0 ->
  let u := ln w / 2 in
  let e := 2 * cosh u / exp (u * tanh u) - 1 in
  let m1 := m2 * Rpower w N in
  let eta := Rpower (1 + e) (2 * N) * m1 * m2 / Rpower (Rpower m1 (1 / N) + Rpower m2 (1 / N)) (2 * N) in
  N = ln (m1 / m2) / (2 * u) /\
  eta = Rpower (m2 / m1) (tanh u).

Definition b_power_attained_defined : Prop :=
  forall (w : R), w > 1 ->
  forall (m2 N : R), m2 > 0 -> N > 0 ->
  ln w <> 0 /\
  (m2 * Rpower w N) / m2 > 0 /\
  m2 <> 0 /\
  w > 0 /\
  1 + (2 * cosh (ln w / 2) / exp ((ln w / 2) * tanh (ln w / 2)) - 1) > 0 /\
  exp ((ln w / 2) * tanh (ln w / 2)) <> 0 /\
  Rpower (m2 * Rpower w N) (1 / N) + Rpower m2 (1 / N) > 0 /\
  m2 * Rpower w N > 0 /\
  N <> 0 /\
  m2 > 0 /\
  m2 / (m2 * Rpower w N) > 0.

Definition b_power_range : Prop :=
  forall (w : R), w > 1 ->
  forall (t : R), t > 0 ->
  let u := ln w / 2 in
  let e := 2 * cosh u / exp (u * tanh u) - 1 in
  (0 < e /\ e < 1) /\
  is_derive (fun t : R => t * tanh t - ln (cosh t)) t (t * sech t ^ 2) /\
  t * sech t ^ 2 > 0.

Definition b_power_range_defined : Prop :=
  forall (w : R), w > 1 ->
  forall (t : R), t > 0 ->
  exp ((ln w / 2) * tanh (ln w / 2)) <> 0 /\
  w > 0 /\
  ex_derive (fun t : R => t * tanh t - ln (cosh t)) t /\
  cosh t > 0.

Definition b_superball : Prop :=
  forall (x : R), x > 0 ->
  forall (e e_f : R), 0 <= e <= 1 -> 0 <= e_f <= 1 ->
  forall (v : R), v > 0 ->
  forall (k : nat),
  forall u : nat -> R, u 0%nat = (1 + e_f) * v ->
  (forall j : nat, u (j + 1)%nat = x * (1 + e) / (x + 1) * u j) ->
  u k - v = ((x * (1 + e) / (x + 1)) ^ k * (1 + e_f) - 1) * v.

Definition b_superball_defined : Prop :=
  forall (x : R), x > 0 ->
  forall (e e_f : R), 0 <= e <= 1 -> 0 <= e_f <= 1 ->
  forall (v : R), v > 0 ->
  forall (k : nat),
  forall u : nat -> R, u 0%nat = (1 + e_f) * v ->
  (forall j : nat, u (j + 1)%nat = x * (1 + e) / (x + 1) * u j) ->
  (forall j : nat, x + 1 <> 0) /\
  x + 1 <> 0.

Definition b_superball_limit : Prop :=
  forall (x v g : R), x > 0 -> v > 0 -> g > 0 ->
  is_lim (fun x : R => (2 * x / (x + 1) * 2 * v - v) / v) p_infty 3 /\
  is_lim (fun x : R => ((2 * x / (x + 1) * 2 * v - v) ^ 2 / (2 * g)) / (v ^ 2 / (2 * g))) p_infty 9.

Definition b_superball_limit_defined : Prop :=
  forall (x v g : R), x > 0 -> v > 0 -> g > 0 ->
  v <> 0 /\
  x + 1 <> 0 /\
  g <> 0.

Definition lemma_bernoulli : Prop :=
  forall (h : R), h > - 1 ->
  forall (n : nat),
  (1 + h) ^ n >= 1 + INR n * h.

Definition lemma_chain : Prop :=
  forall (mu : nat -> R), (forall k : nat, mu k > 0) ->
  forall (r : R), r > 0 ->
  forall (n : nat),
  let p := r / (1 + r) in
  product_over 0 n (fun i : nat => mu i + mu (i + 1)%nat) * Rpower (mu 0%nat) p * Rpower r (p * INR (n +
      1)) >= product_over 0 n (fun i : nat => mu i) * (1 + r) ^ (n + 1) * Rpower (mu (n + 1)%nat) p.

Definition lemma_chain_defined : Prop :=
  forall (mu : nat -> R), (forall k : nat, mu k > 0) ->
  forall (r : R), r > 0 ->
  forall (n : nat),
  mu 0%nat > 0 /\
  1 + r <> 0 /\
  r > 0 /\
  mu (n + 1)%nat > 0.

Definition lemma_chain_last : Prop :=
  forall (mu : nat -> R), (forall k : nat, mu k > 0) ->
  forall (r : R), r > 0 ->
  forall (j : nat),
  let p := r / (1 + r) in
  mu (j + 1)%nat <> mu j * r -> product_over 0 j (fun i : nat => mu i + mu (i + 1)%nat) *
      Rpower (mu 0%nat) p * Rpower r (p * INR (j + 1)) >
      product_over 0 j (fun i : nat => mu i) * (1 + r) ^ (j + 1) * Rpower (mu (j + 1)%nat) p.

Definition lemma_chain_last_defined : Prop :=
  forall (mu : nat -> R), (forall k : nat, mu k > 0) ->
  forall (r : R), r > 0 ->
  forall (j : nat),
  mu 0%nat > 0 /\
  1 + r <> 0 /\
  r > 0 /\
  mu (j + 1)%nat > 0.

Definition lemma_chain_strict : Prop :=
  forall (mu : nat -> R), (forall k : nat, mu k > 0) ->
  forall (r : R), r > 0 ->
  forall (j k : nat),
  let p := r / (1 + r) in
  mu (j + 1)%nat <> mu j * r ->
  product_over 0 (j + k) (fun i : nat => mu i + mu (i + 1)%nat) * Rpower (mu 0%nat) p * Rpower r (p * INR (j +
      k + 1)) > product_over 0 (j + k) (fun i : nat => mu i) * (1 + r) ^ (j + k + 1) * Rpower (mu (j + k +
      1)%nat) p.

Definition lemma_chain_strict_defined : Prop :=
  forall (mu : nat -> R), (forall k : nat, mu k > 0) ->
  forall (r : R), r > 0 ->
  forall (j k : nat),
  mu (j + 1)%nat <> mu j * r ->
  mu 0%nat > 0 /\
  1 + r <> 0 /\
  r > 0 /\
  mu (j + k + 1)%nat > 0.

Definition lemma_elastic_bound : Prop :=
  forall (r : R), r > 0 ->
  forall (n : nat), (n >= 1)%nat ->
  let t := Rpower r (1 / INR n) in
  let eta := (4 * t / (1 + t) ^ 2) ^ n in
  eta <= 1 /\
  (r >= 1 -> eta >= 1 - (r - 1) ^ 2 / INR n) /\
  (r <= 1 -> eta >= 1 - (1 / r - 1) ^ 2 / INR n).

Definition lemma_elastic_bound_defined : Prop :=
  forall (r : R), r > 0 ->
  forall (n : nat), (n >= 1)%nat ->
  1 + Rpower r (1 / INR n) <> 0 /\
  r > 0 /\
  INR n <> 0 /\
  r <> 0.

Definition lemma_tangent : Prop :=
  forall (a b r : R), a > 0 -> b > 0 -> r > 0 ->
  let p := r / (1 + r) in
  let bound := a * (1 + r) * Rpower (b / (a * r)) p in
  a + b >= bound /\
  (b <> a * r -> a + b > bound).

Definition lemma_tangent_defined : Prop :=
  forall (a b r : R), a > 0 -> b > 0 -> r > 0 ->
  b / (a * r) > 0 /\
  a <> 0 /\
  r <> 0 /\
  1 + r <> 0.
