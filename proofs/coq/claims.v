(** Every claim in full, with the place of its proof. NAME is the claim of that name (its
    negation, where the claim is expected to be refuted); NAME_defined says that, under the same
    hypotheses, all its expressions have values. No other file is imported than [vocabulary], so
    that nothing of the proofs has a say in what the statements mean.

    This part is written by `carom export coq --theorems`: change the claim files, not this one. *)

From Carom Require Import vocabulary.
From Carom Require closed collision four limit many transfer.

Theorem eq01 :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (v1 v2 w1 w2 J : R),
  m1 * (w1 - v1) = - J ->
  m2 * (w2 - v2) = J ->
  m1 * v1 + m2 * v2 = m1 * w1 + m2 * w2.
Proof. exact collision.eq01. Qed.

Theorem eq02 :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (v1 v2 w1 w2 : R),
  m1 * v1 + m2 * v2 = m1 * w1 + m2 * w2 ->
  v1 - v2 = - (w1 - w2) ->
  m1 * v1 ^ 2 / 2 + m2 * v2 ^ 2 / 2 = m1 * w1 ^ 2 / 2 + m2 * w2 ^ 2 / 2.
Proof. exact collision.eq02. Qed.

Theorem eq03 :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (v1 v2 w1 w2 : R),
  w1 <> v1 ->
  m1 * v1 + m2 * v2 = m1 * w1 + m2 * w2 ->
  m1 * v1 ^ 2 / 2 + m2 * v2 ^ 2 / 2 = m1 * w1 ^ 2 / 2 + m2 * w2 ^ 2 / 2 ->
  v1 - v2 = - (w1 - w2).
Proof. exact collision.eq03. Qed.

Theorem eq03_unguarded :
  ~ (
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (v1 v2 w1 w2 : R),
  m1 * v1 + m2 * v2 = m1 * w1 + m2 * w2 ->
  m1 * v1 ^ 2 / 2 + m2 * v2 ^ 2 / 2 = m1 * w1 ^ 2 / 2 + m2 * w2 ^ 2 / 2 ->
  v1 - v2 = - (w1 - w2)).
Proof. exact collision.eq03_unguarded. Qed.

Theorem eq04 :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  forall (v1 v2 w1 w2 : R),
  v1 <> v2 ->
  m1 * v1 + m2 * v2 = m1 * w1 + m2 * w2 ->
  v2 - v1 <> 0 ->
  e = - ((w2 - w1) / (v2 - v1)) ->
  e = 1 <-> m1 * v1 ^ 2 / 2 + m2 * v2 ^ 2 / 2 = m1 * w1 ^ 2 / 2 + m2 * w2 ^ 2 / 2.
Proof. exact collision.eq04. Qed.

Theorem eq05 :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  forall (v1 v2 w1 w2 : R),
  m1 * v1 + m2 * v2 = m1 * w1 + m2 * w2 ->
  w2 - w1 = - (e * (v2 - v1)) ->
  w1 = (m1 - e * m2) / (m1 + m2) * v1 + m2 * (1 + e) / (m1 + m2) * v2.
Proof. exact collision.eq05. Qed.

Theorem eq05_defined :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  forall (v1 v2 w1 w2 : R),
  m1 * v1 + m2 * v2 = m1 * w1 + m2 * w2 ->
  w2 - w1 = - (e * (v2 - v1)) ->
  m1 + m2 <> 0.
Proof. exact collision.eq05_defined. Qed.

Theorem eq05_unique :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  forall (v1 v2 w1 w2 : R),
  m1 * v1 + m2 * v2 = m1 * w1 + m2 * w2 /\ w2 - w1 = - (e * (v2 - v1)) <-> w1 =
      (m1 - e * m2) / (m1 + m2) * v1 + m2 * (1 + e) / (m1 + m2) * v2 /\ w2 =
      m1 * (1 + e) / (m1 + m2) * v1 + (m2 - e * m1) / (m1 + m2) * v2.
Proof. exact collision.eq05_unique. Qed.

Theorem eq05_unique_defined :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  forall (v1 v2 w1 w2 : R),
  m1 + m2 <> 0.
Proof. exact collision.eq05_unique_defined. Qed.

Theorem eq06 :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  forall (v1 v2 w1 w2 : R),
  m1 * v1 + m2 * v2 = m1 * w1 + m2 * w2 ->
  w2 - w1 = - (e * (v2 - v1)) ->
  w2 = m1 * (1 + e) / (m1 + m2) * v1 + (m2 - e * m1) / (m1 + m2) * v2.
Proof. exact collision.eq06. Qed.

Theorem eq06_defined :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  forall (v1 v2 w1 w2 : R),
  m1 * v1 + m2 * v2 = m1 * w1 + m2 * w2 ->
  w2 - w1 = - (e * (v2 - v1)) ->
  m1 + m2 <> 0.
Proof. exact collision.eq06_defined. Qed.

Theorem eq07 :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  forall (v1 v2 w1 w2 : R),
  m1 * v1 + m2 * v2 = m1 * w1 + m2 * w2 ->
  w2 - w1 = - (e * (v2 - v1)) ->
  let x := m1 / m2 in
  [[w1]; [w2]] = mat_scale (1 / (m1 + m2)) (mat_mul [[m1 - e * m2; m2 * (1 + e)]; [m1 * (1 + e); m2 - e *
      m1]] [[v1]; [v2]]) /\
  [[w1]; [w2]] = mat_scale (1 / (x + 1)) (mat_mul [[x - e; 1 + e]; [x * (1 + e); 1 - e * x]] [[v1]; [v2]]).
Proof. exact collision.eq07. Qed.

Theorem eq07_defined :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  forall (v1 v2 w1 w2 : R),
  m1 * v1 + m2 * v2 = m1 * w1 + m2 * w2 ->
  w2 - w1 = - (e * (v2 - v1)) ->
  m1 + m2 <> 0 /\
  m1 / m2 + 1 <> 0 /\
  m2 <> 0.
Proof. exact collision.eq07_defined. Qed.

Theorem eq08 :
  forall (m1 m2 v1 : R), m1 > 0 -> m2 > 0 -> v1 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  let w2 := m1 * (1 + e) / (m1 + m2) * v1 in
  (m2 * w2 ^ 2 / 2) / (m1 * v1 ^ 2 / 2) = (1 + e) ^ 2 * m1 * m2 / (m1 + m2) ^ 2.
Proof. exact collision.eq08. Qed.

Theorem eq08_defined :
  forall (m1 m2 v1 : R), m1 > 0 -> m2 > 0 -> v1 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  m1 <> 0 /\
  v1 <> 0 /\
  m1 + m2 <> 0.
Proof. exact collision.eq08_defined. Qed.

Theorem eq09 :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  let x := m1 / m2 in
  (1 + e) ^ 2 * m1 * m2 / (m1 + m2) ^ 2 = (1 + e) ^ 2 * x / (1 + x) ^ 2.
Proof. exact collision.eq09. Qed.

Theorem eq09_defined :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  m1 + m2 <> 0 /\
  1 + m1 / m2 <> 0 /\
  m2 <> 0.
Proof. exact collision.eq09_defined. Qed.

Theorem eq10 :
  forall (x : R), x > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  let share := (1 + e) ^ 2 * x / (1 + x) ^ 2 in
  (share = 1 <-> x - (1 + e) * sqrt x + 1 = 0) /\
  (share = 1 <-> e = 1 /\ x = 1).
Proof. exact collision.eq10. Qed.

Theorem eq10_defined :
  forall (x : R), x > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  1 + x <> 0 /\
  0 <= x.
Proof. exact collision.eq10_defined. Qed.

Theorem eq10_extracted :
  ~ (
  forall (x : R), x > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  (1 + e) ^ 2 * x / (1 + x) ^ 2 = 1 <-> x - (1 + e) * x + 1 = 0).
Proof. exact collision.eq10_extracted. Qed.

Theorem eq10_roots :
  forall (e y s : R),
  s ^ 2 = (e + 3) * (e - 1) ->
  y ^ 2 - (1 + e) * y + 1 = (y - (1 + e + s) / 2) * (y - (1 + e - s) / 2) /\
  ((y - (1 + e + s) / 2) * (y - (1 + e - s) / 2) = 0 <-> y = (1 + e + s) / 2 \/ y = (1 + e - s) / 2).
Proof. exact collision.eq10_roots. Qed.

Theorem eq11 :
  forall (e : R), 0 <= e <= 1 ->
  let f := fun (x : R) => (1 + e) ^ 2 * x / (1 + x) ^ 2 in
  1 > 0 /\
  f 1 = (1 + e) ^ 2 / 4 /\
  (forall (x : R), x > 0 -> f x <= (1 + e) ^ 2 / 4 /\ (f x = (1 + e) ^ 2 / 4 -> x = 1)).
Proof. exact collision.eq11. Qed.

Theorem eq11_defined :
  forall (e : R), 0 <= e <= 1 ->
  (forall (x : R), x > 0 -> 1 + x <> 0).
Proof. exact collision.eq11_defined. Qed.

Theorem eq12 :
  forall (m1 m2 mu v1 : R), m1 > 0 -> m2 > 0 -> mu > 0 -> v1 > 0 ->
  forall (e1 e2 : R), 0 <= e1 <= 1 -> 0 <= e2 <= 1 ->
  forall (v_mu w2 : R),
  v_mu = m1 * (1 + e1) / (m1 + mu) * v1 ->
  w2 = mu * (1 + e2) / (mu + m2) * v_mu ->
  w2 = (1 + e1) * (1 + e2) * m1 * mu / ((m1 + mu) * (mu + m2)) * v1 /\
  m2 * w2 ^ 2 / 2 = (1 + e1) ^ 2 * (1 + e2) ^ 2 * m1 * m2 * mu ^ 2 / ((m1 + mu) ^ 2 * (mu + m2) ^ 2) * (m1 *
      v1 ^ 2 / 2).
Proof. exact transfer.eq12. Qed.

Theorem eq12_defined :
  forall (m1 m2 mu v1 : R), m1 > 0 -> m2 > 0 -> mu > 0 -> v1 > 0 ->
  forall (e1 e2 : R), 0 <= e1 <= 1 -> 0 <= e2 <= 1 ->
  forall (v_mu w2 : R),
  v_mu = m1 * (1 + e1) / (m1 + mu) * v1 ->
  w2 = mu * (1 + e2) / (mu + m2) * v_mu ->
  m1 + mu <> 0 /\
  mu + m2 <> 0.
Proof. exact transfer.eq12_defined. Qed.

Theorem eq13 :
  forall (m1 m2 mu : R), m1 > 0 -> m2 > 0 -> mu > 0 ->
  forall (e1 e2 : R), 0 <= e1 <= 1 -> 0 <= e2 <= 1 ->
  forall (v1 : R), v1 > 0 ->
  let v_mu := m1 * (1 + e1) / (m1 + mu) * v1 in
  let v_2 := mu * (1 + e2) / (mu + m2) * v_mu in
  (m2 * v_2 ^ 2 / 2) / (m1 * v1 ^ 2 / 2) =
      (1 + e1) ^ 2 * (1 + e2) ^ 2 * m1 * m2 * mu ^ 2 / ((m1 + mu) ^ 2 * (mu + m2) ^ 2).
Proof. exact transfer.eq13. Qed.

Theorem eq13_defined :
  forall (m1 m2 mu : R), m1 > 0 -> m2 > 0 -> mu > 0 ->
  forall (e1 e2 : R), 0 <= e1 <= 1 -> 0 <= e2 <= 1 ->
  forall (v1 : R), v1 > 0 ->
  m1 <> 0 /\
  v1 <> 0 /\
  mu + m2 <> 0 /\
  m1 + mu <> 0.
Proof. exact transfer.eq13_defined. Qed.

Theorem eq14 :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e1 e2 : R), 0 <= e1 <= 1 -> 0 <= e2 <= 1 ->
  let f := fun (mu : R) => (1 + e1) ^ 2 * (1 + e2) ^ 2 * m1 * m2 * mu ^ 2 / ((m1 + mu) ^ 2 * (mu + m2) ^ 2) in
  sqrt (m1 * m2) > 0 /\
  f (sqrt (m1 * m2)) = (1 + e1) ^ 2 * (1 + e2) ^ 2 * m1 * m2 / (sqrt m1 + sqrt m2) ^ 4 /\
  (forall (mu : R), mu > 0 -> f mu <= (1 + e1) ^ 2 * (1 + e2) ^ 2 * m1 * m2 / (sqrt m1 + sqrt m2) ^ 4 /\
      (f mu = (1 + e1) ^ 2 * (1 + e2) ^ 2 * m1 * m2 / (sqrt m1 + sqrt m2) ^ 4 -> mu = sqrt (m1 * m2))).
Proof. exact transfer.eq14. Qed.

Theorem eq14_defined :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e1 e2 : R), 0 <= e1 <= 1 -> 0 <= e2 <= 1 ->
  0 <= m1 * m2 /\
  sqrt m1 + sqrt m2 <> 0 /\
  0 <= m1 /\
  0 <= m2 /\
  (forall (mu : R), mu > 0 -> m1 + mu <> 0) /\
  (forall (mu : R), mu > 0 -> mu + m2 <> 0).
Proof. exact transfer.eq14_defined. Qed.

Theorem eq15 :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  let eta2 := (1 + e) ^ 2 * m1 * m2 / (m1 + m2) ^ 2 in
  let eta3 := (1 + e) ^ 4 * m1 * m2 / (sqrt m1 + sqrt m2) ^ 4 in
  (eta3 >= eta2 <-> e >= (sqrt m1 + sqrt m2) ^ 2 / (m1 + m2) - 1) /\
  (sqrt m1 + sqrt m2) ^ 2 / (m1 + m2) - 1 = 2 * sqrt (m1 * m2) / (m1 + m2).
Proof. exact transfer.eq15. Qed.

Theorem eq15_defined :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  sqrt m1 + sqrt m2 <> 0 /\
  0 <= m1 /\
  0 <= m2 /\
  m1 + m2 <> 0 /\
  0 <= m1 * m2.
Proof. exact transfer.eq15_defined. Qed.

Theorem eq16 :
  forall (m1 m2 mu1 mu2 v1 : R), m1 > 0 -> m2 > 0 -> mu1 > 0 -> mu2 > 0 -> v1 > 0 ->
  forall (e1 e2 e3 : R), 0 <= e1 <= 1 -> 0 <= e2 <= 1 -> 0 <= e3 <= 1 ->
  let u1 := m1 * (1 + e1) / (m1 + mu1) * v1 in
  let u2 := mu1 * (1 + e2) / (mu1 + mu2) * u1 in
  let u3 := mu2 * (1 + e3) / (mu2 + m2) * u2 in
  (m2 * u3 ^ 2 / 2) / (m1 * v1 ^ 2 / 2) =
      (1 + e1) ^ 2 * (1 + e2) ^ 2 * (1 + e3) ^ 2 * m1 * m2 * mu1 ^ 2 * mu2 ^ 2 / ((m1 + mu1) ^ 2 * (mu1 +
      mu2) ^ 2 * (mu2 + m2) ^ 2).
Proof. exact transfer.eq16. Qed.

Theorem eq16_defined :
  forall (m1 m2 mu1 mu2 v1 : R), m1 > 0 -> m2 > 0 -> mu1 > 0 -> mu2 > 0 -> v1 > 0 ->
  forall (e1 e2 e3 : R), 0 <= e1 <= 1 -> 0 <= e2 <= 1 -> 0 <= e3 <= 1 ->
  m1 <> 0 /\
  v1 <> 0 /\
  mu2 + m2 <> 0 /\
  mu1 + mu2 <> 0 /\
  m1 + mu1 <> 0.
Proof. exact transfer.eq16_defined. Qed.

Theorem eq17 :
  forall (m1 m2 mu1 mu2 : R), m1 > 0 -> m2 > 0 -> mu1 > 0 -> mu2 > 0 ->
  forall (e1 e2 e3 : R), 0 <= e1 <= 1 -> 0 <= e2 <= 1 -> 0 <= e3 <= 1 ->
  let k := (1 + e1) ^ 2 * (1 + e2) ^ 2 * (1 + e3) ^ 2 * m1 * m2 in
  let eta := fun (a : R) (b : R) => k * a ^ 2 * b ^ 2 / ((m1 + a) ^ 2 * (a + b) ^ 2 * (b + m2) ^ 2) in
  let best := k / (cbrt m1 + cbrt m2) ^ 6 in
  eta (cbrt (m1 ^ 2 * m2)) (cbrt (m1 * m2 ^ 2)) = best /\
  eta mu1 mu2 <= best /\
  (eta mu1 mu2 = best <-> mu1 = cbrt (m1 ^ 2 * m2) /\ mu2 = cbrt (m1 * m2 ^ 2)).
Proof. exact four.eq17. Qed.

Theorem eq17_defined :
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
Proof. exact four.eq17_defined. Qed.

Theorem eq18 :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  let eta3 := (1 + e) ^ 4 * m1 * m2 / (sqrt m1 + sqrt m2) ^ 4 in
  let eta4 := (1 + e) ^ 6 * m1 * m2 / (cbrt m1 + cbrt m2) ^ 6 in
  eta4 >= eta3 <-> e >= (cbrt m1 + cbrt m2) ^ 3 / (sqrt m1 + sqrt m2) ^ 2 - 1.
Proof. exact four.eq18. Qed.

Theorem eq18_defined :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  cbrt m1 + cbrt m2 <> 0 /\
  m1 > 0 /\
  m2 > 0 /\
  sqrt m1 + sqrt m2 <> 0 /\
  0 <= m1 /\
  0 <= m2.
Proof. exact four.eq18_defined. Qed.

Theorem eq18_extracted :
  ~ (
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  let eta2 := (1 + e) ^ 2 * m1 * m2 / (m1 + m2) ^ 2 in
  let eta3 := (1 + e) ^ 4 * m1 * m2 / (sqrt m1 + sqrt m2) ^ 4 in
  sqrt (eta3 / eta2) >= 1 <-> e >= (cbrt m1 + cbrt m2) ^ 3 / (sqrt m1 + sqrt m2) ^ 2 - 1).
Proof. exact four.eq18_extracted. Qed.

Theorem eq19 :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  forall (n : nat), (n >= 1)%nat ->
  let S := fun (k : nat) => Rpower m1 (1 / INR k) + Rpower m2 (1 / INR k) in
  let eta := fun (k : nat) => (1 + e) ^ (2 * k) * m1 * m2 / S k ^ (2 * k) in
  let L := S (n + 1)%nat ^ (n + 1) / S n ^ n - 1 in
  eta (n + 1)%nat >= eta n <-> L <= e.
Proof. exact many.eq19. Qed.

Theorem eq19_defined :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  forall (n : nat), (n >= 1)%nat ->
  Rpower m1 (1 / INR (n + 1)) + Rpower m2 (1 / INR (n + 1)) <> 0 /\
  m1 > 0 /\
  INR (n + 1) <> 0 /\
  m2 > 0 /\
  Rpower m1 (1 / INR n) + Rpower m2 (1 / INR n) <> 0 /\
  INR n <> 0.
Proof. exact many.eq19_defined. Qed.

Theorem eq20 :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (n : nat), (n >= 1)%nat ->
  forall (i : nat), (i >= 1)%nat ->
  (i <= n)%nat ->
  let mu := fun (k : R) => Rpower m1 ((INR n + 1 - k) / INR (n + 1)) * Rpower m2 (k / INR (n + 1)) in
  mu (INR i) = sqrt (mu (INR i - 1) * mu (INR (i + 1))) /\
  mu 0 = m1 /\
  mu (INR (n + 1)) = m2.
Proof. exact many.eq20. Qed.

Theorem eq20_defined :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (n : nat), (n >= 1)%nat ->
  forall (i : nat), (i >= 1)%nat ->
  (i <= n)%nat ->
  m1 > 0 /\
  INR (n + 1) <> 0 /\
  m2 > 0 /\
  0 <= (Rpower m1 ((INR n + 1 - (INR i - 1)) / INR (n + 1)) * Rpower m2 ((INR i - 1) / INR (n + 1))) *
      (Rpower m1 ((INR n + 1 - INR (i + 1)) / INR (n + 1)) * Rpower m2 (INR (i + 1) / INR (n + 1))).
Proof. exact many.eq20_defined. Qed.

Theorem eq20_converse :
  forall (mu : nat -> R), (forall k : nat, mu k > 0) ->
  forall (n : nat),
  (forall (k : nat), mu (k + 1)%nat ^ 2 = mu k * mu (k + 2)%nat) ->
  mu (n + 1)%nat / mu n = mu 1%nat / mu 0%nat.
Proof. exact many.eq20_converse. Qed.

Theorem eq20_converse_defined :
  forall (mu : nat -> R), (forall k : nat, mu k > 0) ->
  forall (n : nat),
  (forall (k : nat), mu (k + 1)%nat ^ 2 = mu k * mu (k + 2)%nat) ->
  mu n <> 0 /\
  mu 0%nat <> 0.
Proof. exact many.eq20_converse_defined. Qed.

Theorem eq21 :
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
Proof. exact many.eq21. Qed.

Theorem eq21_defined :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (n : nat), (n >= 1)%nat ->
  forall (i : nat),
  (i <= n)%nat ->
  m1 > 0 /\
  INR (n + 1) <> 0 /\
  m2 > 0 /\
  m1 / m2 > 0 /\
  m2 <> 0.
Proof. exact many.eq21_defined. Qed.

Theorem eq22 :
  forall (x : R), x > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  forall (v1 : R), v1 > 0 ->
  forall u : nat -> R, u 0%nat = v1 ->
  (forall k : nat, u (k + 1)%nat = x * (1 + e) / (x + 1) * u k) ->
  forall (i : nat),
  (x - e) / (x + 1) * u i = (x * (1 + e)) ^ i * (x - e) / (x + 1) ^ (i + 1) * v1.
Proof. exact many.eq22. Qed.

Theorem eq22_defined :
  forall (x : R), x > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  forall (v1 : R), v1 > 0 ->
  forall (i : nat),
  forall u : nat -> R, u 0%nat = v1 ->
  (forall k : nat, u (k + 1)%nat = x * (1 + e) / (x + 1) * u k) ->
  (forall k : nat, x + 1 <> 0) /\
  x + 1 <> 0.
Proof. exact many.eq22_defined. Qed.

Theorem eq23 :
  forall (m1 mu1 v1 : R), m1 > 0 -> mu1 > 0 -> v1 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  let x := m1 / mu1 in
  (m1 - e * mu1) / (m1 + mu1) * v1 = (x - e) / (x + 1) * v1.
Proof. exact many.eq23. Qed.

Theorem eq23_defined :
  forall (m1 mu1 v1 : R), m1 > 0 -> mu1 > 0 -> v1 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  m1 + mu1 <> 0 /\
  m1 / mu1 + 1 <> 0 /\
  mu1 <> 0.
Proof. exact many.eq23_defined. Qed.

Theorem eq24 :
  forall (x : R), x > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  forall (v1 : R), v1 > 0 ->
  forall u : nat -> R, u 0%nat = v1 ->
  (forall k : nat, u (k + 1)%nat = x * (1 + e) / (x + 1) * u k) ->
  forall (n : nat),
  u (n + 1)%nat = (x * (1 + e) / (x + 1)) ^ (n + 1) * v1.
Proof. exact many.eq24. Qed.

Theorem eq24_defined :
  forall (x : R), x > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  forall (v1 : R), v1 > 0 ->
  forall (n : nat),
  forall u : nat -> R, u 0%nat = v1 ->
  (forall k : nat, u (k + 1)%nat = x * (1 + e) / (x + 1) * u k) ->
  (forall k : nat, x + 1 <> 0) /\
  x + 1 <> 0.
Proof. exact many.eq24_defined. Qed.

Theorem eq25 :
  forall (m1 m2 v1 : R), m1 > 0 -> m2 > 0 -> v1 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  forall (n : nat),
  let x := Rpower (m1 / m2) (1 / INR (n + 1)) in
  let w2 := (x * (1 + e) / (x + 1)) ^ (n + 1) * v1 in
  (m2 * w2 ^ 2 / 2) / (m1 * v1 ^ 2 / 2) =
      (1 + e) ^ (2 * (n + 1)) * m1 * m2 / (Rpower m1 (1 / INR (n + 1)) + Rpower m2 (1 / INR (n + 1))) ^ (2 *
      (n + 1)).
Proof. exact many.eq25. Qed.

Theorem eq25_defined :
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
Proof. exact many.eq25_defined. Qed.

Theorem p_elastic :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (n : nat), (n >= 1)%nat ->
  let S := fun (k : nat) => Rpower m1 (1 / INR k) + Rpower m2 (1 / INR k) in
  let eta := fun (k : nat) => 2 ^ (2 * k) * m1 * m2 / S k ^ (2 * k) in
  eta (n + 1)%nat >= eta n /\
  (eta (n + 1)%nat > eta n <-> m1 <> m2).
Proof. exact many.p_elastic. Qed.

Theorem p_elastic_defined :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (n : nat), (n >= 1)%nat ->
  Rpower m1 (1 / INR (n + 1)) + Rpower m2 (1 / INR (n + 1)) <> 0 /\
  m1 > 0 /\
  INR (n + 1) <> 0 /\
  m2 > 0 /\
  Rpower m1 (1 / INR n) + Rpower m2 (1 / INR n) <> 0 /\
  INR n <> 0.
Proof. exact many.p_elastic_defined. Qed.

Theorem p_final :
  ~ (
  forall (x v1 : R), x > 0 -> v1 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  forall (i : nat),
  let u := fun (i : nat) => (x * (1 + e) / (x + 1)) ^ i * v1 in
  let w := fun (i : nat) => (x - e) / (x + 1) * u i in
  w i <= w (i + 1)%nat).
Proof. exact many.p_final. Qed.

Theorem p_final_repaired :
  forall (x v1 : R), x > 0 -> v1 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  forall (i : nat),
  let u := fun (i : nat) => (x * (1 + e) / (x + 1)) ^ i * v1 in
  let w := fun (i : nat) => (x - e) / (x + 1) * u i in
  (w i <= w (i + 1)%nat <-> x <= e \/ x * e >= 1) /\
  w i <= u (i + 1)%nat.
Proof. exact many.p_final_repaired. Qed.

Theorem p_final_repaired_defined :
  forall (x v1 : R), x > 0 -> v1 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  forall (i : nat),
  x + 1 <> 0.
Proof. exact many.p_final_repaired_defined. Qed.

Theorem p_frame :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  forall (v1 v2 w1 w2 : R),
  m1 * v1 + m2 * v2 = m1 * w1 + m2 * w2 ->
  w2 - w1 = - (e * (v2 - v1)) ->
  forall (s : R),
  (w2 + s) - (w1 + s) = - (e * ((v2 + s) - (v1 + s))) /\
  [[w1 + s]; [w2 + s]] = mat_scale (1 / (m1 + m2)) (mat_mul [[m1 - e * m2; m2 * (1 + e)]; [m1 * (1 + e); m2 -
      e * m1]] [[v1 + s]; [v2 + s]]).
Proof. exact collision.p_frame. Qed.

Theorem p_frame_defined :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  forall (v1 v2 w1 w2 : R),
  forall (s : R),
  m1 * v1 + m2 * v2 = m1 * w1 + m2 * w2 ->
  w2 - w1 = - (e * (v2 - v1)) ->
  m1 + m2 <> 0.
Proof. exact collision.p_frame_defined. Qed.

Theorem p_frame_energy :
  exists (e : R), 0 <= e <= 1 /\ exists (m1 m2 : R), m1 > 0 /\ m2 > 0 /\ exists (v1 v2 s : R), m1 + m2 <> 0 /\
      m1 * v1 ^ 2 + m2 * v2 ^ 2 <> 0 /\ m1 * (v1 + s) ^ 2 + m2 * (v2 + s) ^ 2 <> 0 /\
      m1 * v1 ^ 2 + m2 * v2 ^ 2 <> 0 /\ m1 * (v1 + s) ^ 2 + m2 * (v2 + s) ^ 2 <> 0 /\
      m1 * m2 * (1 - e ^ 2) * (v1 - v2) ^ 2 / (m1 + m2) / (m1 * v1 ^ 2 + m2 * v2 ^ 2) <>
      m1 * m2 * (1 - e ^ 2) * (v1 - v2) ^ 2 / (m1 + m2) / (m1 * (v1 + s) ^ 2 + m2 * (v2 + s) ^ 2).
Proof. exact collision.p_frame_energy. Qed.

Theorem p_full :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  (1 + e) ^ 2 * m1 * m2 / (m1 + m2) ^ 2 = 1 <-> e = 1 /\ m1 = m2.
Proof. exact collision.p_full. Qed.

Theorem p_full_defined :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  m1 + m2 <> 0.
Proof. exact collision.p_full_defined. Qed.

Theorem p_grow :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  let L1 := (sqrt m1 + sqrt m2) ^ 2 / (m1 + m2) - 1 in
  let L2 := (cbrt m1 + cbrt m2) ^ 3 / (sqrt m1 + sqrt m2) ^ 2 - 1 in
  L2 >= L1 /\
  (L2 = L1 <-> m1 = m2).
Proof. exact four.p_grow. Qed.

Theorem p_grow_defined :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  sqrt m1 + sqrt m2 <> 0 /\
  m1 > 0 /\
  m2 > 0 /\
  0 <= m1 /\
  0 <= m2 /\
  m1 + m2 <> 0.
Proof. exact four.p_grow_defined. Qed.

Theorem p_indep :
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
Proof. exact many.p_indep. Qed.

Theorem p_indep_defined :
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
Proof. exact many.p_indep_defined. Qed.

Theorem p_inelastic :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (n : nat), (n >= 1)%nat ->
  let S := fun (k : nat) => Rpower m1 (1 / INR k) + Rpower m2 (1 / INR k) in
  let eta := fun (k : nat) => m1 * m2 / S k ^ (2 * k) in
  eta (n + 1)%nat < eta n.
Proof. exact many.p_inelastic. Qed.

Theorem p_inelastic_defined :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (n : nat), (n >= 1)%nat ->
  Rpower m1 (1 / INR (n + 1)) + Rpower m2 (1 / INR (n + 1)) <> 0 /\
  m1 > 0 /\
  INR (n + 1) <> 0 /\
  m2 > 0 /\
  Rpower m1 (1 / INR n) + Rpower m2 (1 / INR n) <> 0 /\
  INR n <> 0.
Proof. exact many.p_inelastic_defined. Qed.

Theorem p_loss :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  forall (v1 v2 w1 w2 : R),
  m1 * v1 + m2 * v2 = m1 * w1 + m2 * w2 ->
  w2 - w1 = - (e * (v2 - v1)) ->
  let loss := m1 * v1 ^ 2 / 2 + m2 * v2 ^ 2 / 2 - m1 * w1 ^ 2 / 2 - m2 * w2 ^ 2 / 2 in
  loss = m1 * m2 * (1 - e ^ 2) * (v1 - v2) ^ 2 / (2 * (m1 + m2)) /\
  loss >= 0 /\
  (loss = 0 <-> e = 1 \/ v1 = v2).
Proof. exact collision.p_loss. Qed.

Theorem p_loss_defined :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  forall (v1 v2 w1 w2 : R),
  m1 * v1 + m2 * v2 = m1 * w1 + m2 * w2 ->
  w2 - w1 = - (e * (v2 - v1)) ->
  m1 + m2 <> 0.
Proof. exact collision.p_loss_defined. Qed.

Theorem p_order :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  forall (v1 v2 w1 w2 : R),
  m1 * v1 + m2 * v2 = m1 * w1 + m2 * w2 ->
  w2 - w1 = - (e * (v2 - v1)) ->
  v1 >= v2 ->
  w1 <= w2.
Proof. exact collision.p_order. Qed.

Theorem p_rest :
  forall (x v1 : R), x > 0 -> v1 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  forall (i : nat),
  ((x - e) / (x + 1) * v1 = 0 <-> x = e) /\
  ((x * (1 + e)) ^ i * (x - e) / (x + 1) ^ (i + 1) * v1 = 0 <-> x = e).
Proof. exact collision.p_rest. Qed.

Theorem p_rest_defined :
  forall (x v1 : R), x > 0 -> v1 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  forall (i : nat),
  x + 1 <> 0.
Proof. exact collision.p_rest_defined. Qed.

Theorem p_stop :
  forall (m1 m2 v1 : R), m1 > 0 -> m2 > 0 -> v1 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  let w1 := (m1 - e * m2) / (m1 + m2) * v1 in
  let eta := (1 + e) ^ 2 * m1 * m2 / (m1 + m2) ^ 2 in
  (w1 = 0 <-> m1 = e * m2) /\
  (m1 = e * m2 -> eta = e) /\
  e <= (1 + e) ^ 2 / 4 /\
  (e = (1 + e) ^ 2 / 4 <-> e = 1).
Proof. exact collision.p_stop. Qed.

Theorem p_stop_defined :
  forall (m1 m2 v1 : R), m1 > 0 -> m2 > 0 -> v1 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  m1 + m2 <> 0.
Proof. exact collision.p_stop_defined. Qed.

Theorem p_two :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  let L2 := (cbrt m1 + cbrt m2) ^ 3 / (sqrt m1 + sqrt m2) ^ 2 - 1 in
  let eta2 := (1 + e) ^ 2 * m1 * m2 / (m1 + m2) ^ 2 in
  let eta3 := (1 + e) ^ 4 * m1 * m2 / (sqrt m1 + sqrt m2) ^ 4 in
  let eta4 := (1 + e) ^ 6 * m1 * m2 / (cbrt m1 + cbrt m2) ^ 6 in
  e >= L2 ->
  eta4 >= eta3 /\
  eta4 >= eta2.
Proof. exact four.p_two. Qed.

Theorem p_two_defined :
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
Proof. exact four.p_two_defined. Qed.

Theorem p_two_converse :
  ~ (
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  let L2 := (cbrt m1 + cbrt m2) ^ 3 / (sqrt m1 + sqrt m2) ^ 2 - 1 in
  let eta2 := (1 + e) ^ 2 * m1 * m2 / (m1 + m2) ^ 2 in
  let eta4 := (1 + e) ^ 6 * m1 * m2 / (cbrt m1 + cbrt m2) ^ 6 in
  eta4 >= eta2 -> e >= L2).
Proof. exact four.p_two_converse. Qed.

Theorem u1 :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  forall (v1 v2 w1 w2 : R),
  m1 * v1 + m2 * v2 = m1 * w1 + m2 * w2 ->
  w2 - w1 = - (e * (v2 - v1)) ->
  w2 = w1 - e * (v2 - v1) /\
  m1 * v1 + m2 * v2 = (m1 + m2) * w1 - e * m2 * (v2 - v1).
Proof. exact collision.u1. Qed.

Theorem u2 :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  forall (v1 : R),
  let w2 := m1 * (1 + e) / (m1 + m2) * v1 in
  let K1 := m1 * v1 ^ 2 / 2 in
  m2 * w2 ^ 2 / 2 = m2 / 2 * (m1 * (1 + e) / (m1 + m2)) ^ 2 * v1 ^ 2 /\
  m2 * w2 ^ 2 / 2 = (1 + e) ^ 2 * m1 * m2 / (m1 + m2) ^ 2 * K1.
Proof. exact collision.u2. Qed.

Theorem u2_defined :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  forall (v1 : R),
  m1 + m2 <> 0.
Proof. exact collision.u2_defined. Qed.

Theorem u3 :
  forall (x : R), x > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  is_derive (fun x : R => (1 + e) ^ 2 * x / (1 + x) ^ 2) x ((1 + e) ^ 2 * ((1 + x) ^ 2 - 2 * x * (1 + x)) /
      (1 + x) ^ 4) /\
  is_derive (fun x : R => (1 + e) ^ 2 * x / (1 + x) ^ 2) x ((1 + e) ^ 2 * (1 - x) / (1 + x) ^ 3).
Proof. exact transfer.u3. Qed.

Theorem u3_defined :
  forall (x : R), x > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  ex_derive (fun x : R => (1 + e) ^ 2 * x / (1 + x) ^ 2) x /\
  1 + x <> 0.
Proof. exact transfer.u3_defined. Qed.

Theorem u4 :
  forall (m1 mu : R), m1 > 0 -> mu > 0 ->
  forall (e1 : R), 0 <= e1 <= 1 ->
  forall (v1 v w1 w : R),
  m1 * v1 + mu * v = m1 * w1 + mu * w ->
  w - w1 = - (e1 * (v - v1)) ->
  [[w1]; [w]] = mat_scale (1 / (m1 + mu)) (mat_mul [[m1 - e1 * mu; mu * (1 + e1)]; [m1 * (1 + e1); mu - e1 *
      m1]] [[v1]; [v]]).
Proof. exact collision.u4. Qed.

Theorem u4_defined :
  forall (m1 mu : R), m1 > 0 -> mu > 0 ->
  forall (e1 : R), 0 <= e1 <= 1 ->
  forall (v1 v w1 w : R),
  m1 * v1 + mu * v = m1 * w1 + mu * w ->
  w - w1 = - (e1 * (v - v1)) ->
  m1 + mu <> 0.
Proof. exact collision.u4_defined. Qed.

Theorem u5 :
  forall (m1 m2 mu : R), m1 > 0 -> m2 > 0 -> mu > 0 ->
  forall (e1 e2 : R), 0 <= e1 <= 1 -> 0 <= e2 <= 1 ->
  let k1 := 2 * (1 + e1) ^ 2 * (1 + e2) ^ 2 * m1 * m2 in
  is_derive (fun mu : R => (1 + e1) ^ 2 * (1 + e2) ^ 2 * m1 * m2 * mu ^ 2 / ((m1 + mu) ^ 2 * (mu +
      m2) ^ 2)) mu (k1 * mu * ((m1 + mu) * (mu + m2) - mu * (m1 + m2 + 2 * mu)) / ((m1 + mu) ^ 3 * (mu +
      m2) ^ 3)) /\
  is_derive (fun mu : R => (1 + e1) ^ 2 * (1 + e2) ^ 2 * m1 * m2 * mu ^ 2 / ((m1 + mu) ^ 2 * (mu +
      m2) ^ 2)) mu (k1 * mu * (m1 * m2 - mu ^ 2) / ((m1 + mu) ^ 3 * (mu + m2) ^ 3)).
Proof. exact transfer.u5. Qed.

Theorem u5_defined :
  forall (m1 m2 mu : R), m1 > 0 -> m2 > 0 -> mu > 0 ->
  forall (e1 e2 : R), 0 <= e1 <= 1 -> 0 <= e2 <= 1 ->
  ex_derive (fun mu : R => (1 + e1) ^ 2 * (1 + e2) ^ 2 * m1 * m2 * mu ^ 2 / ((m1 + mu) ^ 2 * (mu +
      m2) ^ 2)) mu /\
  m1 + mu <> 0 /\
  mu + m2 <> 0.
Proof. exact transfer.u5_defined. Qed.

Theorem u5_extracted :
  ~ (
  forall (m2 mu x : R), m2 > 0 -> mu > 0 -> x > 0 ->
  forall (e1 e2 : R), 0 <= e1 <= 1 -> 0 <= e2 <= 1 ->
  let m1 := x * m2 in
  let k1 := 2 * (1 + e1) ^ 2 * (1 + e2) ^ 2 * m1 * m2 in
  is_derive (fun x : R => (1 + e1) ^ 2 * (1 + e2) ^ 2 * (x * m2) * m2 * mu ^ 2 / ((x * m2 + mu) ^ 2 * (mu +
      m2) ^ 2)) x (k1 * mu * (m1 * m2 - mu ^ 2) / ((m1 + mu) ^ 3 * (mu + m2) ^ 3))).
Proof. exact transfer.u5_extracted. Qed.

Theorem u6 :
  forall (m1 m2 mu : R), m1 > 0 -> m2 > 0 -> mu > 0 ->
  forall (e1 e2 : R), 0 <= e1 <= 1 -> 0 <= e2 <= 1 ->
  let k1 := 2 * (1 + e1) ^ 2 * (1 + e2) ^ 2 * m1 * m2 in
  let second := fun (t : R) => k1 * ((m1 * m2 - 3 * t ^ 2) * (m1 + t) * (t + m2) - 3 * t * (m1 * m2 - t ^ 2) *
      (m1 + m2 + 2 * t)) / ((m1 + t) ^ 4 * (t + m2) ^ 4) in
  is_derive_n (fun mu : R => (1 + e1) ^ 2 * (1 + e2) ^ 2 * m1 * m2 * mu ^ 2 / ((m1 + mu) ^ 2 * (mu +
      m2) ^ 2)) 2 mu (second mu) /\
  second (sqrt (m1 * m2)) < 0.
Proof. exact transfer.u6. Qed.

Theorem u6_defined :
  forall (m1 m2 mu : R), m1 > 0 -> m2 > 0 -> mu > 0 ->
  forall (e1 e2 : R), 0 <= e1 <= 1 -> 0 <= e2 <= 1 ->
  ex_derive_n (fun mu : R => (1 + e1) ^ 2 * (1 + e2) ^ 2 * m1 * m2 * mu ^ 2 / ((m1 + mu) ^ 2 * (mu +
      m2) ^ 2)) 2 mu /\
  m1 + mu <> 0 /\
  mu + m2 <> 0 /\
  m1 + sqrt (m1 * m2) <> 0 /\
  sqrt (m1 * m2) + m2 <> 0 /\
  0 <= m1 * m2.
Proof. exact transfer.u6_defined. Qed.

Theorem u7 :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  let eta2 := fun (e : R) => (1 + e) ^ 2 * m1 * m2 / (m1 + m2) ^ 2 in
  let eta3 := fun (e : R) => (1 + e) ^ 4 * m1 * m2 / (sqrt m1 + sqrt m2) ^ 4 in
  eta2 1 = 4 * m1 * m2 / (m1 + m2) ^ 2 /\
  eta3 1 = 16 * m1 * m2 / (sqrt m1 + sqrt m2) ^ 4 /\
  eta3 1 / eta2 1 = 4 * (m1 + m2) ^ 2 / (sqrt m1 + sqrt m2) ^ 4.
Proof. exact transfer.u7. Qed.

Theorem u7_defined :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  m1 + m2 <> 0 /\
  sqrt m1 + sqrt m2 <> 0 /\
  0 <= m1 /\
  0 <= m2 /\
  INR (1 + 1) <> 0 /\
  m1 <> 0 /\
  m2 <> 0.
Proof. exact transfer.u7_defined. Qed.

Theorem u8 :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  let ratio := 4 * (m1 + m2) ^ 2 / (sqrt m1 + sqrt m2) ^ 4 in
  sqrt ratio - 1 = ((sqrt m1 - sqrt m2) / (sqrt m1 + sqrt m2)) ^ 2 /\
  sqrt ratio - 1 >= 0.
Proof. exact transfer.u8. Qed.

Theorem u8_defined :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  0 <= 4 * (m1 + m2) ^ 2 / (sqrt m1 + sqrt m2) ^ 4 /\
  sqrt m1 + sqrt m2 <> 0 /\
  0 <= m1 /\
  0 <= m2.
Proof. exact transfer.u8_defined. Qed.

Theorem u8_extracted :
  ~ (
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  let ratio := 4 * (m1 + m2) ^ 2 / (sqrt m1 + sqrt m2) ^ 4 in
  ratio - 1 = ((sqrt m1 - sqrt m2) / (sqrt m1 + sqrt m2)) ^ 2).
Proof. exact transfer.u8_extracted. Qed.

Theorem u9 :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  let ratio := (m1 + m2) ^ 2 / (sqrt m1 + sqrt m2) ^ 4 in
  sqrt ratio - 1 = - (2 * sqrt (m1 * m2) / (sqrt m1 + sqrt m2) ^ 2) /\
  sqrt ratio - 1 <= 0.
Proof. exact transfer.u9. Qed.

Theorem u9_defined :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  0 <= (m1 + m2) ^ 2 / (sqrt m1 + sqrt m2) ^ 4 /\
  sqrt m1 + sqrt m2 <> 0 /\
  0 <= m1 /\
  0 <= m2 /\
  0 <= m1 * m2.
Proof. exact transfer.u9_defined. Qed.

Theorem u9_extracted :
  ~ (
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  let ratio := (m1 + m2) ^ 2 / (sqrt m1 + sqrt m2) ^ 4 in
  ratio - 1 = - (2 * sqrt (m1 * m2) / (sqrt m1 + sqrt m2) ^ 2)).
Proof. exact transfer.u9_extracted. Qed.

Theorem u10 :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e e1 e2 : R), 0 <= e <= 1 -> 0 <= e1 <= 1 -> 0 <= e2 <= 1 ->
  let eta2 := (1 + e) ^ 2 * m1 * m2 / (m1 + m2) ^ 2 in
  let eta3 := (1 + e1) ^ 2 * (1 + e2) ^ 2 * m1 * m2 / (sqrt m1 + sqrt m2) ^ 4 in
  eta3 >= eta2 <-> (1 + e1) * (1 + e2) * (m1 + m2) >= (1 + e) * (sqrt m1 + sqrt m2) ^ 2.
Proof. exact transfer.u10. Qed.

Theorem u10_defined :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e e1 e2 : R), 0 <= e <= 1 -> 0 <= e1 <= 1 -> 0 <= e2 <= 1 ->
  sqrt m1 + sqrt m2 <> 0 /\
  0 <= m1 /\
  0 <= m2 /\
  m1 + m2 <> 0.
Proof. exact transfer.u10_defined. Qed.

Theorem u11 :
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
Proof. exact transfer.u11. Qed.

Theorem u11_defined :
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
Proof. exact transfer.u11_defined. Qed.

Theorem u12 :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  let eta3 := (1 + e) ^ 4 * m1 * m2 / (sqrt m1 + sqrt m2) ^ 4 in
  let eta4 := (1 + e) ^ 6 * m1 * m2 / (cbrt m1 + cbrt m2) ^ 6 in
  eta4 / eta3 = (1 + e) ^ 2 * (sqrt m1 + sqrt m2) ^ 4 / (cbrt m1 + cbrt m2) ^ 6 /\
  (eta4 >= eta3 <-> (1 + e) * (sqrt m1 + sqrt m2) ^ 2 >= (cbrt m1 + cbrt m2) ^ 3).
Proof. exact four.u12. Qed.

Theorem u12_defined :
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
Proof. exact four.u12_defined. Qed.

Theorem u13 :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  let x := m1 / m2 in
  let first := (sqrt m1 + sqrt m2) ^ 2 / (m1 + m2) in
  let second := (cbrt m1 + cbrt m2) ^ 3 / (sqrt m1 + sqrt m2) ^ 2 in
  second / first = (cbrt m1 + cbrt m2) ^ 3 * (m1 + m2) / (sqrt m1 + sqrt m2) ^ 4 /\
  second / first = (cbrt x + 1) ^ 3 * (x + 1) / (sqrt x + 1) ^ 4 /\
  second / first >= 1 /\
  (second / first = 1 <-> m1 = m2).
Proof. exact four.u13. Qed.

Theorem u13_defined :
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
Proof. exact four.u13_defined. Qed.

Theorem b_best :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  forall (n : nat), (n >= 1)%nat ->
  let S := fun (k : nat) => Rpower m1 (1 / INR k) + Rpower m2 (1 / INR k) in
  let eta := fun (k : nat) => (1 + e) ^ (2 * k) * m1 * m2 / S k ^ (2 * k) in
  let L := fun (k : nat) => S (k + 1)%nat ^ (k + 1) / S k ^ k - 1 in
  (eta (n + 2)%nat >= eta (n + 1)%nat -> eta (n + 1)%nat >= eta n) /\
  (eta (n + 1)%nat >= eta n <-> L n <= e) /\
  (m1 = m2 -> L n = 1).
Proof. exact many.b_best. Qed.

Theorem b_best_defined :
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
Proof. exact many.b_best_defined. Qed.

Theorem b_best_after :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  forall (N : nat), (N >= 1)%nat ->
  forall (j : nat),
  let S := fun (k : nat) => Rpower m1 (1 / INR k) + Rpower m2 (1 / INR k) in
  let L := fun (k : nat) => S (k + 1)%nat ^ (k + 1) / S k ^ k - 1 in
  e < L N ->
  e < L (N + j)%nat.
Proof. exact many.b_best_after. Qed.

Theorem b_best_after_defined :
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
Proof. exact many.b_best_after_defined. Qed.

Theorem b_best_elastic :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (n : nat), (n >= 1)%nat ->
  let S := fun (k : nat) => Rpower m1 (1 / INR k) + Rpower m2 (1 / INR k) in
  let L := S (n + 1)%nat ^ (n + 1) / S n ^ n - 1 in
  (m1 <> m2 -> L < 1) /\
  (m1 = m2 -> L = 1).
Proof. exact limit.b_best_elastic. Qed.

Theorem b_best_elastic_defined :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (n : nat), (n >= 1)%nat ->
  Rpower m1 (1 / INR n) + Rpower m2 (1 / INR n) <> 0 /\
  m1 > 0 /\
  INR (n + 1) <> 0 /\
  m2 > 0 /\
  INR n <> 0.
Proof. exact limit.b_best_elastic_defined. Qed.

Theorem b_best_finite :
  forall (m2 : R), m2 > 0 ->
  forall (r : R), r >= 1 ->
  forall (e : R), 0 <= e < 1 ->
  forall (n : nat), (n >= 1)%nat ->
  let m1 := r * m2 in
  let S := fun (k : nat) => Rpower m1 (1 / INR k) + Rpower m2 (1 / INR k) in
  let L := S (n + 1)%nat ^ (n + 1) / S n ^ n - 1 in
  INR n * (1 - e) > 2 * (r - 1) ^ 2 ->
  e < L.
Proof. exact limit.b_best_finite. Qed.

Theorem b_best_finite_defined :
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
Proof. exact limit.b_best_finite_defined. Qed.

Theorem b_budget :
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
Proof. exact many.b_budget. Qed.

Theorem b_budget_defined :
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
Proof. exact many.b_budget_defined. Qed.

Theorem b_closed :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  forall (n : nat), (n >= 1)%nat ->
  let d := ln (m1 / m2) / 2 in
  let S := fun (k : nat) => Rpower m1 (1 / INR k) + Rpower m2 (1 / INR k) in
  (1 + e) ^ (2 * (n + 1)) * m1 * m2 / S (n + 1)%nat ^ (2 * (n + 1)) =
      ((1 + e) / 2 * sech (d / INR (n + 1))) ^ (2 * (n + 1)) /\
  S (n + 1)%nat ^ (n + 1) / S n ^ n - 1 = 2 * cosh (d / INR (n + 1)) ^ (n + 1) / cosh (d / INR n) ^ n - 1.
Proof. exact closed.b_closed. Qed.

Theorem b_closed_defined :
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
Proof. exact closed.b_closed_defined. Qed.

Theorem b_final :
  forall (x : R), x > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  forall (n : nat), (n >= 1)%nat ->
  let L := (1 + x) ^ (n + 1) / (1 + Rpower x (INR (n + 1) / INR n)) ^ n - 1 in
  e >= L ->
  x <= e \/ x * e >= 1.
Proof. exact many.b_final. Qed.

Theorem b_global :
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
Proof. exact many.b_global. Qed.

Theorem b_global_defined :
  forall (mu : nat -> R), (forall k : nat, mu k > 0) ->
  forall (e : nat -> R), (forall k : nat, 0 <= e k <= 1) ->
  forall (n : nat), (n >= 1)%nat ->
  product_over 0 n (fun i : nat => mu i + mu (i + 1)%nat) <> 0 /\
  Rpower (mu 0%nat) (1 / INR (n + 1)) + Rpower (mu (n + 1)%nat) (1 / INR (n + 1)) <> 0 /\
  mu 0%nat > 0 /\
  INR (n + 1) <> 0 /\
  mu (n + 1)%nat > 0.
Proof. exact many.b_global_defined. Qed.

Theorem b_global_unique :
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
Proof. exact many.b_global_unique. Qed.

Theorem b_global_unique_defined :
  forall (mu : nat -> R), (forall k : nat, mu k > 0) ->
  forall (j k : nat),
  forall (e : nat -> R), (forall k : nat, 0 <= e k <= 1) ->
  mu (j + 1)%nat <> mu j * Rpower (mu ((j + k) + 1)%nat / mu 0%nat) (1 / INR ((j + k) + 1)) ->
  product_over 0 (j + k) (fun i : nat => mu i + mu (i + 1)%nat) <> 0 /\
  Rpower (mu 0%nat) (1 / INR ((j + k) + 1)) + Rpower (mu ((j + k) + 1)%nat) (1 / INR ((j + k) + 1)) <> 0 /\
  mu 0%nat > 0 /\
  INR ((j + k) + 1) <> 0 /\
  mu ((j + k) + 1)%nat > 0.
Proof. exact many.b_global_unique_defined. Qed.

Theorem b_grow :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (n : nat), (n >= 1)%nat ->
  let S := fun (k : nat) => Rpower m1 (1 / INR k) + Rpower m2 (1 / INR k) in
  let L := fun (k : nat) => S (k + 1)%nat ^ (k + 1) / S k ^ k - 1 in
  L (n + 1)%nat >= L n /\
  (m1 <> m2 -> L (n + 1)%nat > L n).
Proof. exact many.b_grow. Qed.

Theorem b_grow_defined :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (n : nat), (n >= 1)%nat ->
  Rpower m1 (1 / INR (n + 1)) + Rpower m2 (1 / INR (n + 1)) <> 0 /\
  m1 > 0 /\
  INR ((n + 1) + 1) <> 0 /\
  m2 > 0 /\
  INR (n + 1) <> 0 /\
  Rpower m1 (1 / INR n) + Rpower m2 (1 / INR n) <> 0 /\
  INR n <> 0.
Proof. exact many.b_grow_defined. Qed.

Theorem b_grow_bounded :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (n : nat), (n >= 1)%nat ->
  let S := fun (k : nat) => Rpower m1 (1 / INR k) + Rpower m2 (1 / INR k) in
  S (n + 1)%nat ^ (n + 1) <= 2 * S n ^ n /\
  (m1 <> m2 -> S (n + 1)%nat ^ (n + 1) < 2 * S n ^ n).
Proof. exact many.b_grow_bounded. Qed.

Theorem b_grow_bounded_defined :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (n : nat), (n >= 1)%nat ->
  m1 > 0 /\
  INR (n + 1) <> 0 /\
  m2 > 0 /\
  INR n <> 0.
Proof. exact many.b_grow_bounded_defined. Qed.

Theorem b_grow_limit :
  forall (m2 r : R), m2 > 0 -> r > 0 ->
  forall (n : nat), (n >= 1)%nat ->
  is_lim_seq (fun n : nat => (Rpower (r * m2) (1 / INR (n + 1)) + Rpower m2 (1 / INR (n + 1))) ^ (n + 1) /
      (Rpower (r * m2) (1 / INR n) + Rpower m2 (1 / INR n)) ^ n - 1) 1.
Proof. exact limit.b_grow_limit. Qed.

Theorem b_grow_limit_defined :
  forall (m2 r : R), m2 > 0 -> r > 0 ->
  forall (n : nat), (n >= 1)%nat ->
  Rpower (r * m2) (1 / INR n) + Rpower m2 (1 / INR n) <> 0 /\
  r * m2 > 0 /\
  INR (n + 1) <> 0 /\
  m2 > 0 /\
  INR n <> 0.
Proof. exact limit.b_grow_limit_defined. Qed.

Theorem b_limit :
  forall (m2 r : R), m2 > 0 -> r > 0 ->
  forall (n : nat), (n >= 1)%nat ->
  is_lim_seq (fun n : nat => 4 ^ n * (r * m2) * m2 / (Rpower (r * m2) (1 / INR n) + Rpower m2 (1 /
      INR n)) ^ (2 * n)) 1.
Proof. exact limit.b_limit. Qed.

Theorem b_limit_defined :
  forall (m2 r : R), m2 > 0 -> r > 0 ->
  forall (n : nat), (n >= 1)%nat ->
  Rpower (r * m2) (1 / INR n) + Rpower m2 (1 / INR n) <> 0 /\
  r * m2 > 0 /\
  INR n <> 0 /\
  m2 > 0.
Proof. exact limit.b_limit_defined. Qed.

Theorem b_limit_inelastic :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e < 1 ->
  forall (n : nat), (n >= 1)%nat ->
  is_lim_seq (fun n : nat => (1 + e) ^ (2 * n) * m1 * m2 / (Rpower m1 (1 / INR n) + Rpower m2 (1 /
      INR n)) ^ (2 * n)) 0.
Proof. exact limit.b_limit_inelastic. Qed.

Theorem b_limit_inelastic_defined :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e < 1 ->
  forall (n : nat), (n >= 1)%nat ->
  Rpower m1 (1 / INR n) + Rpower m2 (1 / INR n) <> 0 /\
  m1 > 0 /\
  INR n <> 0 /\
  m2 > 0.
Proof. exact limit.b_limit_inelastic_defined. Qed.

Theorem b_matrix :
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
Proof. exact collision.b_matrix. Qed.

Theorem b_matrix_defined :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  m1 + m2 <> 0.
Proof. exact collision.b_matrix_defined. Qed.

Theorem b_positive :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (n : nat), (n >= 1)%nat ->
  let S := fun (k : nat) => Rpower m1 (1 / INR k) + Rpower m2 (1 / INR k) in
  S (n + 1)%nat ^ (n + 1) > S n ^ n.
Proof. exact many.b_positive. Qed.

Theorem b_positive_defined :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (n : nat), (n >= 1)%nat ->
  m1 > 0 /\
  INR (n + 1) <> 0 /\
  m2 > 0 /\
  INR n <> 0.
Proof. exact many.b_positive_defined. Qed.

Theorem b_power :
  forall (w : R), w > 1 ->
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (N : R), N > 0 ->
  let u := ln w / 2 in
  let e := 2 * cosh u / exp (u * tanh u) - 1 in
  let eta := Rpower (1 + e) (2 * N) * m1 * m2 / Rpower (Rpower m1 (1 / N) + Rpower m2 (1 / N)) (2 * N) in
  u * tanh u - ln (cosh u) = ln (2 / (1 + e)) /\
  eta <= Rpower (m1 / m2) (tanh u) /\
  eta <= Rpower (m2 / m1) (tanh u).
Proof. exact closed.b_power. Qed.

Theorem b_power_defined :
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
Proof. exact closed.b_power_defined. Qed.

Theorem b_power_attained :
  forall (w : R), w > 1 ->
  forall (m2 N : R), m2 > 0 -> N > 0 ->
  let u := ln w / 2 in
  let e := 2 * cosh u / exp (u * tanh u) - 1 in
  let m1 := m2 * Rpower w N in
  let eta := Rpower (1 + e) (2 * N) * m1 * m2 / Rpower (Rpower m1 (1 / N) + Rpower m2 (1 / N)) (2 * N) in
  N = ln (m1 / m2) / (2 * u) /\
  eta = Rpower (m2 / m1) (tanh u).
Proof. exact closed.b_power_attained. Qed.

Theorem b_power_attained_defined :
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
Proof. exact closed.b_power_attained_defined. Qed.

Theorem b_power_range :
  forall (w : R), w > 1 ->
  forall (t : R), t > 0 ->
  let u := ln w / 2 in
  let e := 2 * cosh u / exp (u * tanh u) - 1 in
  (0 < e /\ e < 1) /\
  is_derive (fun t : R => t * tanh t - ln (cosh t)) t (t * sech t ^ 2) /\
  t * sech t ^ 2 > 0.
Proof. exact closed.b_power_range. Qed.

Theorem b_power_range_defined :
  forall (w : R), w > 1 ->
  forall (t : R), t > 0 ->
  exp ((ln w / 2) * tanh (ln w / 2)) <> 0 /\
  w > 0 /\
  ex_derive (fun t : R => t * tanh t - ln (cosh t)) t /\
  cosh t > 0.
Proof. exact closed.b_power_range_defined. Qed.

Theorem b_superball :
  forall (x : R), x > 0 ->
  forall (e e_f : R), 0 <= e <= 1 -> 0 <= e_f <= 1 ->
  forall (v : R), v > 0 ->
  forall (k : nat),
  forall u : nat -> R, u 0%nat = (1 + e_f) * v ->
  (forall j : nat, u (j + 1)%nat = x * (1 + e) / (x + 1) * u j) ->
  u k - v = ((x * (1 + e) / (x + 1)) ^ k * (1 + e_f) - 1) * v.
Proof. exact many.b_superball. Qed.

Theorem b_superball_defined :
  forall (x : R), x > 0 ->
  forall (e e_f : R), 0 <= e <= 1 -> 0 <= e_f <= 1 ->
  forall (v : R), v > 0 ->
  forall (k : nat),
  forall u : nat -> R, u 0%nat = (1 + e_f) * v ->
  (forall j : nat, u (j + 1)%nat = x * (1 + e) / (x + 1) * u j) ->
  (forall j : nat, x + 1 <> 0) /\
  x + 1 <> 0.
Proof. exact many.b_superball_defined. Qed.

Theorem b_superball_limit :
  forall (x v g : R), x > 0 -> v > 0 -> g > 0 ->
  is_lim (fun x : R => (2 * x / (x + 1) * 2 * v - v) / v) p_infty 3 /\
  is_lim (fun x : R => ((2 * x / (x + 1) * 2 * v - v) ^ 2 / (2 * g)) / (v ^ 2 / (2 * g))) p_infty 9.
Proof. exact closed.b_superball_limit. Qed.

Theorem b_superball_limit_defined :
  forall (x v g : R), x > 0 -> v > 0 -> g > 0 ->
  v <> 0 /\
  x + 1 <> 0 /\
  g <> 0.
Proof. exact closed.b_superball_limit_defined. Qed.

Theorem lemma_bernoulli :
  forall (h : R), h > - 1 ->
  forall (n : nat),
  (1 + h) ^ n >= 1 + INR n * h.
Proof. exact limit.lemma_bernoulli. Qed.

Theorem lemma_chain :
  forall (mu : nat -> R), (forall k : nat, mu k > 0) ->
  forall (r : R), r > 0 ->
  forall (n : nat),
  let p := r / (1 + r) in
  product_over 0 n (fun i : nat => mu i + mu (i + 1)%nat) * Rpower (mu 0%nat) p * Rpower r (p * INR (n +
      1)) >= product_over 0 n (fun i : nat => mu i) * (1 + r) ^ (n + 1) * Rpower (mu (n + 1)%nat) p.
Proof. exact many.lemma_chain. Qed.

Theorem lemma_chain_defined :
  forall (mu : nat -> R), (forall k : nat, mu k > 0) ->
  forall (r : R), r > 0 ->
  forall (n : nat),
  mu 0%nat > 0 /\
  1 + r <> 0 /\
  r > 0 /\
  mu (n + 1)%nat > 0.
Proof. exact many.lemma_chain_defined. Qed.

Theorem lemma_chain_last :
  forall (mu : nat -> R), (forall k : nat, mu k > 0) ->
  forall (r : R), r > 0 ->
  forall (j : nat),
  let p := r / (1 + r) in
  mu (j + 1)%nat <> mu j * r -> product_over 0 j (fun i : nat => mu i + mu (i + 1)%nat) *
      Rpower (mu 0%nat) p * Rpower r (p * INR (j + 1)) >
      product_over 0 j (fun i : nat => mu i) * (1 + r) ^ (j + 1) * Rpower (mu (j + 1)%nat) p.
Proof. exact many.lemma_chain_last. Qed.

Theorem lemma_chain_last_defined :
  forall (mu : nat -> R), (forall k : nat, mu k > 0) ->
  forall (r : R), r > 0 ->
  forall (j : nat),
  mu 0%nat > 0 /\
  1 + r <> 0 /\
  r > 0 /\
  mu (j + 1)%nat > 0.
Proof. exact many.lemma_chain_last_defined. Qed.

Theorem lemma_chain_strict :
  forall (mu : nat -> R), (forall k : nat, mu k > 0) ->
  forall (r : R), r > 0 ->
  forall (j k : nat),
  let p := r / (1 + r) in
  mu (j + 1)%nat <> mu j * r ->
  product_over 0 (j + k) (fun i : nat => mu i + mu (i + 1)%nat) * Rpower (mu 0%nat) p * Rpower r (p * INR (j +
      k + 1)) > product_over 0 (j + k) (fun i : nat => mu i) * (1 + r) ^ (j + k + 1) * Rpower (mu (j + k +
      1)%nat) p.
Proof. exact many.lemma_chain_strict. Qed.

Theorem lemma_chain_strict_defined :
  forall (mu : nat -> R), (forall k : nat, mu k > 0) ->
  forall (r : R), r > 0 ->
  forall (j k : nat),
  mu (j + 1)%nat <> mu j * r ->
  mu 0%nat > 0 /\
  1 + r <> 0 /\
  r > 0 /\
  mu (j + k + 1)%nat > 0.
Proof. exact many.lemma_chain_strict_defined. Qed.

Theorem lemma_elastic_bound :
  forall (r : R), r > 0 ->
  forall (n : nat), (n >= 1)%nat ->
  let t := Rpower r (1 / INR n) in
  let eta := (4 * t / (1 + t) ^ 2) ^ n in
  eta <= 1 /\
  (r >= 1 -> eta >= 1 - (r - 1) ^ 2 / INR n) /\
  (r <= 1 -> eta >= 1 - (1 / r - 1) ^ 2 / INR n).
Proof. exact limit.lemma_elastic_bound. Qed.

Theorem lemma_elastic_bound_defined :
  forall (r : R), r > 0 ->
  forall (n : nat), (n >= 1)%nat ->
  1 + Rpower r (1 / INR n) <> 0 /\
  r > 0 /\
  INR n <> 0 /\
  r <> 0.
Proof. exact limit.lemma_elastic_bound_defined. Qed.

Theorem lemma_tangent :
  forall (a b r : R), a > 0 -> b > 0 -> r > 0 ->
  let p := r / (1 + r) in
  let bound := a * (1 + r) * Rpower (b / (a * r)) p in
  a + b >= bound /\
  (b <> a * r -> a + b > bound).
Proof. exact many.lemma_tangent. Qed.

Theorem lemma_tangent_defined :
  forall (a b r : R), a > 0 -> b > 0 -> r > 0 ->
  b / (a * r) > 0 /\
  a <> 0 /\
  r <> 0 /\
  1 + r <> 0.
Proof. exact many.lemma_tangent_defined. Qed.

(** * Beyond the claim files

    Written by hand: what the prover takes as known, and what is stronger than the claims. *)

From Carom Require further.

(** The weighted mean inequality for two values, the analytic lemma of the prover (`mean`). *)
Theorem mean_of_two : forall a b p, a > 0 -> b > 0 -> 0 <= p <= 1 ->
  Rpower a (1 - p) * Rpower b p <= (1 - p) * a + p * b /\
  (a <> b -> 0 < p < 1 -> Rpower a (1 - p) * Rpower b p < (1 - p) * a + p * b).
Proof. exact further.mean_of_two. Qed.

(** Hölder's inequality for two values (`hoelder`). *)
Theorem hoelder_of_two : forall a b c d p, a > 0 -> b > 0 -> c > 0 -> d > 0 -> 0 <= p <= 1 ->
  Rpower a (1 - p) * Rpower c p + Rpower b (1 - p) * Rpower d p <= Rpower (a + b) (1 - p) * Rpower (c + d) p /\
  (a * d <> b * c -> 0 < p < 1 ->
   Rpower a (1 - p) * Rpower c p + Rpower b (1 - p) * Rpower d p < Rpower (a + b) (1 - p) * Rpower (c + d) p).
Proof. exact further.hoelder_of_two. Qed.

(** b-global with its case of equality: the geometric chain (21) and no other. *)
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
Proof. exact further.best_chain. Qed.

(** The best number of inserted bodies, for e < 1: eta k is the share with k collisions. *)
Theorem best_number : forall m1 m2 e, m1 > 0 -> m2 > 0 -> 0 <= e < 1 ->
  let S := fun k : nat => Rpower m1 (1 / INR k) + Rpower m2 (1 / INR k) in
  let L := fun n : nat => S (n + 1)%nat ^ (n + 1) / S n ^ n - 1 in
  let eta := fun k : nat => (1 + e) ^ (2 * k) * m1 * m2 / S k ^ (2 * k) in
  exists nstar : nat,
  (forall n : nat, (n >= 1)%nat -> (L n <= e <-> (n <= nstar)%nat)) /\
  (forall k : nat, (k >= 1)%nat -> eta k <= eta (nstar + 1)%nat) /\
  (forall k : nat, (k >= 1)%nat -> eta k = eta (nstar + 1)%nat ->
    k = (nstar + 1)%nat \/ (k = nstar /\ L nstar = e)).
Proof. exact further.best_number. Qed.

(** Every threshold lies in (0, 1]: at e = 1 each further body helps or does no harm, at e = 0 none helps. *)
Theorem always_helps : forall m1 m2 n, m1 > 0 -> m2 > 0 -> (n >= 1)%nat ->
  let S := fun k : nat => Rpower m1 (1 / INR k) + Rpower m2 (1 / INR k) in
  0 < S (n + 1)%nat ^ (n + 1) / S n ^ n - 1 <= 1.
Proof. exact further.always_helps. Qed.

(** From the two laws of a collision: v t i is the velocity of body i after t collisions, collision t
    joins bodies t and t + 1. *)
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
Proof. exact further.from_the_laws. Qed.

(** The same with one restitution, to (25), and for the best masses to (22), (23) and (24). *)
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
Proof. exact further.to_25. Qed.

(** Such runs exist, for all masses and restitutions: the last two theorems are not empty. *)
Theorem a_run_exists : forall (n : nat) (mu e : nat -> R) (v1 : R), (forall k, mu k > 0) ->
  exists v : nat -> nat -> R,
  v 0%nat 0%nat = v1 /\ (forall i, (1 <= i <= n + 1)%nat -> v 0%nat i = 0) /\
  (forall t, (t <= n)%nat ->
    mu t * v t t + mu (t + 1)%nat * v t (t + 1)%nat
      = mu t * v (t + 1)%nat t + mu (t + 1)%nat * v (t + 1)%nat (t + 1)%nat /\
    v (t + 1)%nat (t + 1)%nat - v (t + 1)%nat t = - (e t * (v t (t + 1)%nat - v t t)) /\
    (forall i, (i <= n + 1)%nat -> i <> t -> i <> (t + 1)%nat -> v (t + 1)%nat i = v t i)).
Proof. exact further.a_run_exists. Qed.
