(** Every claim in full, with the place of its proof. NAME is the claim of that name (its
    negation, where the claim is expected to be refuted); NAME_defined says that, under the same
    hypotheses, all its expressions have values. No other file is imported than [vocabulary], so
    that nothing of the proofs has a say in what the statements mean. The proofs are files that
    `carom export coq --proofs` makes from certificates.

    This part is written by `carom export coq --theorems`: change the claim files, not this one. *)

From Carom Require Import vocabulary.
From Carom Require b_best b_best_after b_best_elastic b_best_finite b_budget b_closed b_final b_global.
From Carom Require b_global_unique b_grow b_grow_bounded b_grow_limit b_insert b_insert_each b_limit b_limit_inelastic.
From Carom Require b_matrix b_positive b_power b_power_attained b_power_range b_superball b_superball_limit eq01.
From Carom Require eq02 eq03 eq03_unguarded eq04 eq05 eq05_unique eq06 eq07.
From Carom Require eq08 eq09 eq10 eq10_extracted eq10_roots eq11 eq12 eq13.
From Carom Require eq14 eq15 eq16 eq17 eq18 eq18_extracted eq19 eq20.
From Carom Require eq20_converse eq21 eq22 eq23 eq24 eq25 lemma_bernoulli lemma_chain.
From Carom Require lemma_chain_last lemma_chain_strict lemma_elastic_bound lemma_tangent p_elastic p_final p_final_repaired p_frame.
From Carom Require p_frame_energy p_full p_grow p_indep p_inelastic p_loss p_order p_rest.
From Carom Require p_stop p_two p_two_converse u1 u10 u11 u12 u13.
From Carom Require u2 u3 u4 u5 u5_extracted u6 u7 u8.
From Carom Require u8_extracted u9 u9_extracted.

(* statement sha256 276d5510de838795c0eb08cc2ce1974ff641f2ce275e14ae1066fc2162415a39 *)
Theorem eq01 :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (v1 v2 w1 w2 J : R),
  m1 * (w1 - v1) = - J ->
  m2 * (w2 - v2) = J ->
  m1 * v1 + m2 * v2 = m1 * w1 + m2 * w2.
Proof. exact eq01.eq01. Qed.

(* statement sha256 1e9c86941e81f3ece48ce1b2739b8ce081b1ed781a7002481f176fadf23edca6 *)
Theorem eq02 :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (v1 v2 w1 w2 : R),
  m1 * v1 + m2 * v2 = m1 * w1 + m2 * w2 ->
  v1 - v2 = - (w1 - w2) ->
  m1 * v1 ^ 2 / 2 + m2 * v2 ^ 2 / 2 = m1 * w1 ^ 2 / 2 + m2 * w2 ^ 2 / 2.
Proof. exact eq02.eq02. Qed.

(* statement sha256 340ac3dffe4fa659d93911cc9b662c41dd441f0bc14600918717f0247d126320 *)
Theorem eq03 :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (v1 v2 w1 w2 : R),
  w1 <> v1 ->
  m1 * v1 + m2 * v2 = m1 * w1 + m2 * w2 ->
  m1 * v1 ^ 2 / 2 + m2 * v2 ^ 2 / 2 = m1 * w1 ^ 2 / 2 + m2 * w2 ^ 2 / 2 ->
  v1 - v2 = - (w1 - w2).
Proof. exact eq03.eq03. Qed.

(* statement sha256 2d210a4d26d91fc0abdd4581f05e0900116d0cb9933072276026f20fcbc7dddd *)
Theorem eq03_unguarded :
  ~ (
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (v1 v2 w1 w2 : R),
  m1 * v1 + m2 * v2 = m1 * w1 + m2 * w2 ->
  m1 * v1 ^ 2 / 2 + m2 * v2 ^ 2 / 2 = m1 * w1 ^ 2 / 2 + m2 * w2 ^ 2 / 2 ->
  v1 - v2 = - (w1 - w2)).
Proof. exact eq03_unguarded.eq03_unguarded. Qed.

(* statement sha256 efeb822743ead02a6b15de094c370bb3712d58751b702fd4766042fd9bf4f18a *)
Theorem eq04 :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  forall (v1 v2 w1 w2 : R),
  v1 <> v2 ->
  m1 * v1 + m2 * v2 = m1 * w1 + m2 * w2 ->
  v2 - v1 <> 0 ->
  e = - ((w2 - w1) / (v2 - v1)) ->
  e = 1 <-> m1 * v1 ^ 2 / 2 + m2 * v2 ^ 2 / 2 = m1 * w1 ^ 2 / 2 + m2 * w2 ^ 2 / 2.
Proof. exact eq04.eq04. Qed.

(* statement sha256 612c1725d0f60a4705fa661fc9e2df00be522e4c480576e1cc91ecbb3f03ba6e *)
Theorem eq05 :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  forall (v1 v2 w1 w2 : R),
  m1 * v1 + m2 * v2 = m1 * w1 + m2 * w2 ->
  w2 - w1 = - (e * (v2 - v1)) ->
  w1 = (m1 - e * m2) / (m1 + m2) * v1 + m2 * (1 + e) / (m1 + m2) * v2.
Proof. exact eq05.eq05. Qed.

Theorem eq05_defined :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  forall (v1 v2 w1 w2 : R),
  m1 * v1 + m2 * v2 = m1 * w1 + m2 * w2 ->
  w2 - w1 = - (e * (v2 - v1)) ->
  m1 + m2 <> 0.
Proof. exact eq05.eq05_defined. Qed.

(* statement sha256 38964c74442fb21f740147091bfe1e943952a15defd1ef38f89adc24cf29e2c5 *)
Theorem eq05_unique :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  forall (v1 v2 w1 w2 : R),
  m1 * v1 + m2 * v2 = m1 * w1 + m2 * w2 /\ w2 - w1 = - (e * (v2 - v1)) <-> w1 =
      (m1 - e * m2) / (m1 + m2) * v1 + m2 * (1 + e) / (m1 + m2) * v2 /\ w2 =
      m1 * (1 + e) / (m1 + m2) * v1 + (m2 - e * m1) / (m1 + m2) * v2.
Proof. exact eq05_unique.eq05_unique. Qed.

Theorem eq05_unique_defined :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  forall (v1 v2 w1 w2 : R),
  m1 + m2 <> 0.
Proof. exact eq05_unique.eq05_unique_defined. Qed.

(* statement sha256 265b8acff9f86523bf3bef5ca25af1945a7f59c7764d18bf16529a411664ab47 *)
Theorem eq06 :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  forall (v1 v2 w1 w2 : R),
  m1 * v1 + m2 * v2 = m1 * w1 + m2 * w2 ->
  w2 - w1 = - (e * (v2 - v1)) ->
  w2 = m1 * (1 + e) / (m1 + m2) * v1 + (m2 - e * m1) / (m1 + m2) * v2.
Proof. exact eq06.eq06. Qed.

Theorem eq06_defined :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  forall (v1 v2 w1 w2 : R),
  m1 * v1 + m2 * v2 = m1 * w1 + m2 * w2 ->
  w2 - w1 = - (e * (v2 - v1)) ->
  m1 + m2 <> 0.
Proof. exact eq06.eq06_defined. Qed.

(* statement sha256 3cee9cbdd93e075ec6a33bd86cb710d7871ce5dd67138666f33f18f94344d39c *)
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
Proof. exact eq07.eq07. Qed.

Theorem eq07_defined :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  forall (v1 v2 w1 w2 : R),
  m1 * v1 + m2 * v2 = m1 * w1 + m2 * w2 ->
  w2 - w1 = - (e * (v2 - v1)) ->
  m1 + m2 <> 0 /\
  m1 / m2 + 1 <> 0 /\
  m2 <> 0.
Proof. exact eq07.eq07_defined. Qed.

(* statement sha256 aae54d649998880360b6b0cc5339c0b6e367fcb7dcbbea348f0cfce0eb4d1d53 *)
Theorem eq08 :
  forall (m1 m2 v1 : R), m1 > 0 -> m2 > 0 -> v1 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  let w2 := m1 * (1 + e) / (m1 + m2) * v1 in
  (m2 * w2 ^ 2 / 2) / (m1 * v1 ^ 2 / 2) = (1 + e) ^ 2 * m1 * m2 / (m1 + m2) ^ 2.
Proof. exact eq08.eq08. Qed.

Theorem eq08_defined :
  forall (m1 m2 v1 : R), m1 > 0 -> m2 > 0 -> v1 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  m1 <> 0 /\
  v1 <> 0 /\
  m1 + m2 <> 0.
Proof. exact eq08.eq08_defined. Qed.

(* statement sha256 76a79b54cd62cb67e3cb9e6c7ed44bdda1999222dd3efc03ba4d11f4faff9d6d *)
Theorem eq09 :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  let x := m1 / m2 in
  (1 + e) ^ 2 * m1 * m2 / (m1 + m2) ^ 2 = (1 + e) ^ 2 * x / (1 + x) ^ 2.
Proof. exact eq09.eq09. Qed.

Theorem eq09_defined :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  m1 + m2 <> 0 /\
  1 + m1 / m2 <> 0 /\
  m2 <> 0.
Proof. exact eq09.eq09_defined. Qed.

(* statement sha256 2c3b06ea60d71279514672912b35f91fd8854e79617a2f53b2237fd3d03191d6 *)
Theorem eq10 :
  forall (x : R), x > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  let share := (1 + e) ^ 2 * x / (1 + x) ^ 2 in
  (share = 1 <-> x - (1 + e) * sqrt x + 1 = 0) /\
  (share = 1 <-> e = 1 /\ x = 1).
Proof. exact eq10.eq10. Qed.

Theorem eq10_defined :
  forall (x : R), x > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  1 + x <> 0 /\
  0 <= x.
Proof. exact eq10.eq10_defined. Qed.

(* statement sha256 4a28a9e8043c42b2f6a0b228ff7c895dd6c4131c101c8b6028e2489d5d528f64 *)
Theorem eq10_extracted :
  ~ (
  forall (x : R), x > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  (1 + e) ^ 2 * x / (1 + x) ^ 2 = 1 <-> x - (1 + e) * x + 1 = 0).
Proof. exact eq10_extracted.eq10_extracted. Qed.

(* statement sha256 e94876ed5d35845a936fdc5927c4712c8f7fd2c0059278a3a74340f1d1c34221 *)
Theorem eq10_roots :
  forall (e y s : R),
  s ^ 2 = (e + 3) * (e - 1) ->
  y ^ 2 - (1 + e) * y + 1 = (y - (1 + e + s) / 2) * (y - (1 + e - s) / 2) /\
  ((y - (1 + e + s) / 2) * (y - (1 + e - s) / 2) = 0 <-> y = (1 + e + s) / 2 \/ y = (1 + e - s) / 2).
Proof. exact eq10_roots.eq10_roots. Qed.

(* statement sha256 ad03b0f7a731d182480cb4fa3af132616fad483b7215ee5f17c066c1d50e3533 *)
Theorem eq11 :
  forall (e : R), 0 <= e <= 1 ->
  let f := fun (x : R) => (1 + e) ^ 2 * x / (1 + x) ^ 2 in
  1 > 0 /\
  f 1 = (1 + e) ^ 2 / 4 /\
  (forall (x : R), x > 0 -> f x <= (1 + e) ^ 2 / 4 /\ (f x = (1 + e) ^ 2 / 4 -> x = 1)).
Proof. exact eq11.eq11. Qed.

Theorem eq11_defined :
  forall (e : R), 0 <= e <= 1 ->
  (forall (x : R), x > 0 -> 1 + x <> 0).
Proof. exact eq11.eq11_defined. Qed.

(* statement sha256 9c67d9dfc2ee570e47ef8170388d89f3b4d668c443484e24f5030cd9651554e8 *)
Theorem eq12 :
  forall (m1 m2 mu v1 : R), m1 > 0 -> m2 > 0 -> mu > 0 -> v1 > 0 ->
  forall (e1 e2 : R), 0 <= e1 <= 1 -> 0 <= e2 <= 1 ->
  forall (v_mu w2 : R),
  v_mu = m1 * (1 + e1) / (m1 + mu) * v1 ->
  w2 = mu * (1 + e2) / (mu + m2) * v_mu ->
  w2 = (1 + e1) * (1 + e2) * m1 * mu / ((m1 + mu) * (mu + m2)) * v1 /\
  m2 * w2 ^ 2 / 2 = (1 + e1) ^ 2 * (1 + e2) ^ 2 * m1 * m2 * mu ^ 2 / ((m1 + mu) ^ 2 * (mu + m2) ^ 2) * (m1 *
      v1 ^ 2 / 2).
Proof. exact eq12.eq12. Qed.

Theorem eq12_defined :
  forall (m1 m2 mu v1 : R), m1 > 0 -> m2 > 0 -> mu > 0 -> v1 > 0 ->
  forall (e1 e2 : R), 0 <= e1 <= 1 -> 0 <= e2 <= 1 ->
  forall (v_mu w2 : R),
  v_mu = m1 * (1 + e1) / (m1 + mu) * v1 ->
  w2 = mu * (1 + e2) / (mu + m2) * v_mu ->
  m1 + mu <> 0 /\
  mu + m2 <> 0.
Proof. exact eq12.eq12_defined. Qed.

(* statement sha256 0e3acd7095dd2622933cecfb8237b4b9164ae7bbd02dd9e6ca37232d2016b03d *)
Theorem eq13 :
  forall (m1 m2 mu : R), m1 > 0 -> m2 > 0 -> mu > 0 ->
  forall (e1 e2 : R), 0 <= e1 <= 1 -> 0 <= e2 <= 1 ->
  forall (v1 : R), v1 > 0 ->
  let v_mu := m1 * (1 + e1) / (m1 + mu) * v1 in
  let v_2 := mu * (1 + e2) / (mu + m2) * v_mu in
  (m2 * v_2 ^ 2 / 2) / (m1 * v1 ^ 2 / 2) =
      (1 + e1) ^ 2 * (1 + e2) ^ 2 * m1 * m2 * mu ^ 2 / ((m1 + mu) ^ 2 * (mu + m2) ^ 2).
Proof. exact eq13.eq13. Qed.

Theorem eq13_defined :
  forall (m1 m2 mu : R), m1 > 0 -> m2 > 0 -> mu > 0 ->
  forall (e1 e2 : R), 0 <= e1 <= 1 -> 0 <= e2 <= 1 ->
  forall (v1 : R), v1 > 0 ->
  m1 <> 0 /\
  v1 <> 0 /\
  mu + m2 <> 0 /\
  m1 + mu <> 0.
Proof. exact eq13.eq13_defined. Qed.

(* statement sha256 c6d6dab12710f37bb978ec341b9fa41005a9bac34b4cfe9232d3e891d3e9cdea *)
Theorem eq14 :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e1 e2 : R), 0 <= e1 <= 1 -> 0 <= e2 <= 1 ->
  let f := fun (mu : R) => (1 + e1) ^ 2 * (1 + e2) ^ 2 * m1 * m2 * mu ^ 2 / ((m1 + mu) ^ 2 * (mu + m2) ^ 2) in
  sqrt (m1 * m2) > 0 /\
  f (sqrt (m1 * m2)) = (1 + e1) ^ 2 * (1 + e2) ^ 2 * m1 * m2 / (sqrt m1 + sqrt m2) ^ 4 /\
  (forall (mu : R), mu > 0 -> f mu <= (1 + e1) ^ 2 * (1 + e2) ^ 2 * m1 * m2 / (sqrt m1 + sqrt m2) ^ 4 /\
      (f mu = (1 + e1) ^ 2 * (1 + e2) ^ 2 * m1 * m2 / (sqrt m1 + sqrt m2) ^ 4 -> mu = sqrt (m1 * m2))).
Proof. exact eq14.eq14. Qed.

Theorem eq14_defined :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e1 e2 : R), 0 <= e1 <= 1 -> 0 <= e2 <= 1 ->
  0 <= m1 * m2 /\
  sqrt m1 + sqrt m2 <> 0 /\
  0 <= m1 /\
  0 <= m2 /\
  (forall (mu : R), mu > 0 -> m1 + mu <> 0) /\
  (forall (mu : R), mu > 0 -> mu + m2 <> 0).
Proof. exact eq14.eq14_defined. Qed.

(* statement sha256 20a54a3bb03b868217786c502ec1a8b3a522c436967bc6d0c9bef74590934727 *)
Theorem eq15 :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  let eta2 := (1 + e) ^ 2 * m1 * m2 / (m1 + m2) ^ 2 in
  let eta3 := (1 + e) ^ 4 * m1 * m2 / (sqrt m1 + sqrt m2) ^ 4 in
  (eta3 >= eta2 <-> e >= (sqrt m1 + sqrt m2) ^ 2 / (m1 + m2) - 1) /\
  (sqrt m1 + sqrt m2) ^ 2 / (m1 + m2) - 1 = 2 * sqrt (m1 * m2) / (m1 + m2).
Proof. exact eq15.eq15. Qed.

Theorem eq15_defined :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  sqrt m1 + sqrt m2 <> 0 /\
  0 <= m1 /\
  0 <= m2 /\
  m1 + m2 <> 0 /\
  0 <= m1 * m2.
Proof. exact eq15.eq15_defined. Qed.

(* statement sha256 c1d47dbe364e16ee06c9fb14f33d1f4c3355db31b3cafc61a6581ff03eaa1273 *)
Theorem eq16 :
  forall (m1 m2 mu1 mu2 v1 : R), m1 > 0 -> m2 > 0 -> mu1 > 0 -> mu2 > 0 -> v1 > 0 ->
  forall (e1 e2 e3 : R), 0 <= e1 <= 1 -> 0 <= e2 <= 1 -> 0 <= e3 <= 1 ->
  let u1 := m1 * (1 + e1) / (m1 + mu1) * v1 in
  let u2 := mu1 * (1 + e2) / (mu1 + mu2) * u1 in
  let u3 := mu2 * (1 + e3) / (mu2 + m2) * u2 in
  (m2 * u3 ^ 2 / 2) / (m1 * v1 ^ 2 / 2) =
      (1 + e1) ^ 2 * (1 + e2) ^ 2 * (1 + e3) ^ 2 * m1 * m2 * mu1 ^ 2 * mu2 ^ 2 / ((m1 + mu1) ^ 2 * (mu1 +
      mu2) ^ 2 * (mu2 + m2) ^ 2).
Proof. exact eq16.eq16. Qed.

Theorem eq16_defined :
  forall (m1 m2 mu1 mu2 v1 : R), m1 > 0 -> m2 > 0 -> mu1 > 0 -> mu2 > 0 -> v1 > 0 ->
  forall (e1 e2 e3 : R), 0 <= e1 <= 1 -> 0 <= e2 <= 1 -> 0 <= e3 <= 1 ->
  m1 <> 0 /\
  v1 <> 0 /\
  mu2 + m2 <> 0 /\
  mu1 + mu2 <> 0 /\
  m1 + mu1 <> 0.
Proof. exact eq16.eq16_defined. Qed.

(* statement sha256 a968c4630d767266876228fc20fb6b2f6a1da6664c8c0cc327bf76c7c5c0dd71 *)
Theorem lemma_tangent :
  forall (a b r : R), a > 0 -> b > 0 -> r > 0 ->
  let p := r / (1 + r) in
  let bound := a * (1 + r) * Rpower (b / (a * r)) p in
  a + b >= bound /\
  (b <> a * r -> a + b > bound).
Proof. exact lemma_tangent.lemma_tangent. Qed.

Theorem lemma_tangent_defined :
  forall (a b r : R), a > 0 -> b > 0 -> r > 0 ->
  b / (a * r) > 0 /\
  a <> 0 /\
  r <> 0 /\
  1 + r <> 0.
Proof. exact lemma_tangent.lemma_tangent_defined. Qed.

(* statement sha256 3a67f7d020c7309b87a7151ef4178136b724a97d2c350ae1f7b715477dd1aa78 *)
Theorem eq17 :
  forall (m1 m2 mu1 mu2 : R), m1 > 0 -> m2 > 0 -> mu1 > 0 -> mu2 > 0 ->
  forall (e1 e2 e3 : R), 0 <= e1 <= 1 -> 0 <= e2 <= 1 -> 0 <= e3 <= 1 ->
  let k := (1 + e1) ^ 2 * (1 + e2) ^ 2 * (1 + e3) ^ 2 * m1 * m2 in
  let eta := fun (a : R) (b : R) => k * a ^ 2 * b ^ 2 / ((m1 + a) ^ 2 * (a + b) ^ 2 * (b + m2) ^ 2) in
  let best := k / (cbrt m1 + cbrt m2) ^ 6 in
  eta (cbrt (m1 ^ 2 * m2)) (cbrt (m1 * m2 ^ 2)) = best /\
  eta mu1 mu2 <= best /\
  (eta mu1 mu2 = best <-> mu1 = cbrt (m1 ^ 2 * m2) /\ mu2 = cbrt (m1 * m2 ^ 2)).
Proof. exact eq17.eq17. Qed.

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
Proof. exact eq17.eq17_defined. Qed.

(* statement sha256 e47ac82dbd743d459b2d1401d4e7d2da1667caab143dd64938a843a53c45a201 *)
Theorem eq18 :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  let eta3 := (1 + e) ^ 4 * m1 * m2 / (sqrt m1 + sqrt m2) ^ 4 in
  let eta4 := (1 + e) ^ 6 * m1 * m2 / (cbrt m1 + cbrt m2) ^ 6 in
  eta4 >= eta3 <-> e >= (cbrt m1 + cbrt m2) ^ 3 / (sqrt m1 + sqrt m2) ^ 2 - 1.
Proof. exact eq18.eq18. Qed.

Theorem eq18_defined :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  cbrt m1 + cbrt m2 <> 0 /\
  m1 > 0 /\
  m2 > 0 /\
  sqrt m1 + sqrt m2 <> 0 /\
  0 <= m1 /\
  0 <= m2.
Proof. exact eq18.eq18_defined. Qed.

(* statement sha256 e77f935aa295f36e8bf683f35dfab7a5d80c79487ce036b3a7ba87d1bf1e3eef *)
Theorem eq18_extracted :
  ~ (
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  let eta2 := (1 + e) ^ 2 * m1 * m2 / (m1 + m2) ^ 2 in
  let eta3 := (1 + e) ^ 4 * m1 * m2 / (sqrt m1 + sqrt m2) ^ 4 in
  sqrt (eta3 / eta2) >= 1 <-> e >= (cbrt m1 + cbrt m2) ^ 3 / (sqrt m1 + sqrt m2) ^ 2 - 1).
Proof. exact eq18_extracted.eq18_extracted. Qed.

(* statement sha256 6e374cb0dca252d2a087607001381e5f7b9c16ded438b4dec4cd0c040a5c624e *)
Theorem eq19 :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  forall (n : nat), (n >= 1)%nat ->
  let S := fun (k : nat) => Rpower m1 (1 / INR k) + Rpower m2 (1 / INR k) in
  let eta := fun (k : nat) => (1 + e) ^ (2 * k) * m1 * m2 / S k ^ (2 * k) in
  let L := S (n + 1)%nat ^ (n + 1) / S n ^ n - 1 in
  eta (n + 1)%nat >= eta n <-> L <= e.
Proof. exact eq19.eq19. Qed.

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
Proof. exact eq19.eq19_defined. Qed.

(* statement sha256 76a4b26643def854648677e6e80dba11e3be68e70feedeac1b366e44325d02fa *)
Theorem eq20 :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (n : nat), (n >= 1)%nat ->
  forall (i : nat), (i >= 1)%nat ->
  (i <= n)%nat ->
  let mu := fun (k : R) => Rpower m1 ((INR n + 1 - k) / INR (n + 1)) * Rpower m2 (k / INR (n + 1)) in
  mu (INR i) = sqrt (mu (INR i - 1) * mu (INR (i + 1))) /\
  mu 0 = m1 /\
  mu (INR (n + 1)) = m2.
Proof. exact eq20.eq20. Qed.

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
Proof. exact eq20.eq20_defined. Qed.

(* statement sha256 46456558176cb363ffc6977ae082d8003d3fba493aae20c1e4769d9d60852d7e *)
Theorem eq20_converse :
  forall (mu : nat -> R), (forall k : nat, mu k > 0) ->
  forall (n : nat),
  (forall (k : nat), mu (k + 1)%nat ^ 2 = mu k * mu (k + 2)%nat) ->
  mu (n + 1)%nat / mu n = mu 1%nat / mu 0%nat.
Proof. exact eq20_converse.eq20_converse. Qed.

Theorem eq20_converse_defined :
  forall (mu : nat -> R), (forall k : nat, mu k > 0) ->
  forall (n : nat),
  (forall (k : nat), mu (k + 1)%nat ^ 2 = mu k * mu (k + 2)%nat) ->
  mu n <> 0 /\
  mu 0%nat <> 0.
Proof. exact eq20_converse.eq20_converse_defined. Qed.

(* statement sha256 93ac0248963ecac3ede0ce9cb0e1c0bce2b1f5f0a65adf71c7605355e39c11f0 *)
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
Proof. exact eq21.eq21. Qed.

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
Proof. exact eq21.eq21_defined. Qed.

(* statement sha256 8865126684762217a4f6980068b1e975f3babee8f268619ad3c8af3052ff0567 *)
Theorem eq22 :
  forall (x : R), x > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  forall (v1 : R), v1 > 0 ->
  forall u : nat -> R, u 0%nat = v1 ->
  (forall k : nat, u (k + 1)%nat = x * (1 + e) / (x + 1) * u k) ->
  forall (i : nat),
  (x - e) / (x + 1) * u i = (x * (1 + e)) ^ i * (x - e) / (x + 1) ^ (i + 1) * v1.
Proof. exact eq22.eq22. Qed.

Theorem eq22_defined :
  forall (x : R), x > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  forall (v1 : R), v1 > 0 ->
  forall (i : nat),
  forall u : nat -> R, u 0%nat = v1 ->
  (forall k : nat, u (k + 1)%nat = x * (1 + e) / (x + 1) * u k) ->
  (forall k : nat, x + 1 <> 0) /\
  x + 1 <> 0.
Proof. exact eq22.eq22_defined. Qed.

(* statement sha256 3b9db916ab1a52de13db853d187560bd6d8392e3559366449efe9863b7f49cef *)
Theorem eq23 :
  forall (m1 mu1 v1 : R), m1 > 0 -> mu1 > 0 -> v1 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  let x := m1 / mu1 in
  (m1 - e * mu1) / (m1 + mu1) * v1 = (x - e) / (x + 1) * v1.
Proof. exact eq23.eq23. Qed.

Theorem eq23_defined :
  forall (m1 mu1 v1 : R), m1 > 0 -> mu1 > 0 -> v1 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  m1 + mu1 <> 0 /\
  m1 / mu1 + 1 <> 0 /\
  mu1 <> 0.
Proof. exact eq23.eq23_defined. Qed.

(* statement sha256 91fc1891980a73a6a8c5375c32ad6bb382bd33418e9ac2f5f9031a0f062b322c *)
Theorem eq24 :
  forall (x : R), x > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  forall (v1 : R), v1 > 0 ->
  forall u : nat -> R, u 0%nat = v1 ->
  (forall k : nat, u (k + 1)%nat = x * (1 + e) / (x + 1) * u k) ->
  forall (n : nat),
  u (n + 1)%nat = (x * (1 + e) / (x + 1)) ^ (n + 1) * v1.
Proof. exact eq24.eq24. Qed.

Theorem eq24_defined :
  forall (x : R), x > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  forall (v1 : R), v1 > 0 ->
  forall (n : nat),
  forall u : nat -> R, u 0%nat = v1 ->
  (forall k : nat, u (k + 1)%nat = x * (1 + e) / (x + 1) * u k) ->
  (forall k : nat, x + 1 <> 0) /\
  x + 1 <> 0.
Proof. exact eq24.eq24_defined. Qed.

(* statement sha256 b0259366d88c4680314f81d004f6ef59b28c772f271d704da14ae726536f3dfc *)
Theorem eq25 :
  forall (m1 m2 v1 : R), m1 > 0 -> m2 > 0 -> v1 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  forall (n : nat),
  let x := Rpower (m1 / m2) (1 / INR (n + 1)) in
  let w2 := (x * (1 + e) / (x + 1)) ^ (n + 1) * v1 in
  (m2 * w2 ^ 2 / 2) / (m1 * v1 ^ 2 / 2) =
      (1 + e) ^ (2 * (n + 1)) * m1 * m2 / (Rpower m1 (1 / INR (n + 1)) + Rpower m2 (1 / INR (n + 1))) ^ (2 *
      (n + 1)).
Proof. exact eq25.eq25. Qed.

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
Proof. exact eq25.eq25_defined. Qed.

(* statement sha256 2fc76e52f194c00dd9710eb09ddbc2a449b4df1fc3f7ebc42ddd798985fe106f *)
Theorem b_grow_bounded :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (n : nat), (n >= 1)%nat ->
  let S := fun (k : nat) => Rpower m1 (1 / INR k) + Rpower m2 (1 / INR k) in
  S (n + 1)%nat ^ (n + 1) <= 2 * S n ^ n /\
  (m1 <> m2 -> S (n + 1)%nat ^ (n + 1) < 2 * S n ^ n).
Proof. exact b_grow_bounded.b_grow_bounded. Qed.

Theorem b_grow_bounded_defined :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (n : nat), (n >= 1)%nat ->
  m1 > 0 /\
  INR (n + 1) <> 0 /\
  m2 > 0 /\
  INR n <> 0.
Proof. exact b_grow_bounded.b_grow_bounded_defined. Qed.

(* statement sha256 162abbe7a97c8a5edd325c0f873427f9d1cfdbfe9ce2a02207bfaf01dbdd5a75 *)
Theorem p_elastic :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (n : nat), (n >= 1)%nat ->
  let S := fun (k : nat) => Rpower m1 (1 / INR k) + Rpower m2 (1 / INR k) in
  let eta := fun (k : nat) => 2 ^ (2 * k) * m1 * m2 / S k ^ (2 * k) in
  eta (n + 1)%nat >= eta n /\
  (eta (n + 1)%nat > eta n <-> m1 <> m2).
Proof. exact p_elastic.p_elastic. Qed.

Theorem p_elastic_defined :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (n : nat), (n >= 1)%nat ->
  Rpower m1 (1 / INR (n + 1)) + Rpower m2 (1 / INR (n + 1)) <> 0 /\
  m1 > 0 /\
  INR (n + 1) <> 0 /\
  m2 > 0 /\
  Rpower m1 (1 / INR n) + Rpower m2 (1 / INR n) <> 0 /\
  INR n <> 0.
Proof. exact p_elastic.p_elastic_defined. Qed.

(* statement sha256 42efb116dd7bba7a766435df6aeb872b5834d600981733b209ecde37bfd239a3 *)
Theorem p_final :
  ~ (
  forall (x v1 : R), x > 0 -> v1 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  forall (i : nat),
  let u := fun (k : nat) => (x * (1 + e) / (x + 1)) ^ k * v1 in
  let w := fun (k : nat) => (x - e) / (x + 1) * u k in
  w i <= w (i + 1)%nat).
Proof. exact p_final.p_final. Qed.

(* statement sha256 c863c770d7de69251a742958fce0817895a30e8309bf80e4871436f37270113b *)
Theorem p_final_repaired :
  forall (x v1 : R), x > 0 -> v1 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  forall (i : nat),
  let u := fun (k : nat) => (x * (1 + e) / (x + 1)) ^ k * v1 in
  let w := fun (k : nat) => (x - e) / (x + 1) * u k in
  (w i <= w (i + 1)%nat <-> x <= e \/ x * e >= 1) /\
  w i <= u (i + 1)%nat.
Proof. exact p_final_repaired.p_final_repaired. Qed.

Theorem p_final_repaired_defined :
  forall (x v1 : R), x > 0 -> v1 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  forall (i : nat),
  x + 1 <> 0.
Proof. exact p_final_repaired.p_final_repaired_defined. Qed.

(* statement sha256 3dcbdc55e2991237c720bc2dcef396a6f36c284b3b2a223246a79801d8d258a4 *)
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
Proof. exact p_frame.p_frame. Qed.

Theorem p_frame_defined :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  forall (v1 v2 w1 w2 : R),
  forall (s : R),
  m1 * v1 + m2 * v2 = m1 * w1 + m2 * w2 ->
  w2 - w1 = - (e * (v2 - v1)) ->
  m1 + m2 <> 0.
Proof. exact p_frame.p_frame_defined. Qed.

(* statement sha256 d0ded100509a1aa749cde4faae4781dda7e11df406d099ac8152010da84085c3 *)
Theorem p_frame_energy :
  exists (e : R), 0 <= e <= 1 /\ exists (m1 m2 : R), m1 > 0 /\ m2 > 0 /\ exists (v1 v2 s : R), m1 + m2 <> 0 /\
      m1 * v1 ^ 2 + m2 * v2 ^ 2 <> 0 /\ m1 * (v1 + s) ^ 2 + m2 * (v2 + s) ^ 2 <> 0 /\
      m1 * v1 ^ 2 + m2 * v2 ^ 2 <> 0 /\ m1 * (v1 + s) ^ 2 + m2 * (v2 + s) ^ 2 <> 0 /\
      m1 * m2 * (1 - e ^ 2) * (v1 - v2) ^ 2 / (m1 + m2) / (m1 * v1 ^ 2 + m2 * v2 ^ 2) <>
      m1 * m2 * (1 - e ^ 2) * (v1 - v2) ^ 2 / (m1 + m2) / (m1 * (v1 + s) ^ 2 + m2 * (v2 + s) ^ 2).
Proof. exact p_frame_energy.p_frame_energy. Qed.

(* statement sha256 64815bfe542a3068ea9547dbc4eb8e2e0a3c7f06cb078f0b1f4d1a68b30dfec2 *)
Theorem p_full :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  (1 + e) ^ 2 * m1 * m2 / (m1 + m2) ^ 2 = 1 <-> e = 1 /\ m1 = m2.
Proof. exact p_full.p_full. Qed.

Theorem p_full_defined :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  m1 + m2 <> 0.
Proof. exact p_full.p_full_defined. Qed.

(* statement sha256 555c6459ef141b09741eb0d8bf059950dd246d8309a8ca2d9f7d3fa96a9aee1c *)
Theorem p_grow :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  let L1 := (sqrt m1 + sqrt m2) ^ 2 / (m1 + m2) - 1 in
  let L2 := (cbrt m1 + cbrt m2) ^ 3 / (sqrt m1 + sqrt m2) ^ 2 - 1 in
  L2 >= L1 /\
  (L2 = L1 <-> m1 = m2).
Proof. exact p_grow.p_grow. Qed.

Theorem p_grow_defined :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  sqrt m1 + sqrt m2 <> 0 /\
  m1 > 0 /\
  m2 > 0 /\
  0 <= m1 /\
  0 <= m2 /\
  m1 + m2 <> 0.
Proof. exact p_grow.p_grow_defined. Qed.

(* statement sha256 ce33978db67c308e932861d842fef149583a7a5bfae804272b602d6251ec50ed *)
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
Proof. exact p_indep.p_indep. Qed.

Theorem p_indep_defined :
  forall (n : nat),
  forall (mu nu : nat -> R), (forall k : nat, mu k > 0) -> (forall k : nat, nu k > 0) ->
  forall (e f : nat -> R), (forall k : nat, 0 <= e k <= 1) -> (forall k : nat, 0 <= f k <= 1) ->
  mu 0%nat = nu 0%nat /\ mu (n + 1)%nat = nu (n + 1)%nat ->
  product_over 0 n (fun i : nat => (1 + e i) * nu i / (nu i + nu (i + 1)%nat)) <> 0 /\
  (forall i : nat, (0 <= i <= n)%nat -> mu i + mu (i + 1)%nat <> 0) /\
  (forall i : nat, (0 <= i <= n)%nat -> nu i + nu (i + 1)%nat <> 0) /\
  product_over 0 n (fun i : nat => (1 + f i) * nu i / (nu i + nu (i + 1)%nat)) <> 0.
Proof. exact p_indep.p_indep_defined. Qed.

(* statement sha256 73559ad9ab305dfd27b5b4e732a2e749f8c99382a98ba72b7adddc9b4b68df54 *)
Theorem b_positive :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (n : nat), (n >= 1)%nat ->
  let S := fun (k : nat) => Rpower m1 (1 / INR k) + Rpower m2 (1 / INR k) in
  S (n + 1)%nat ^ (n + 1) > S n ^ n.
Proof. exact b_positive.b_positive. Qed.

Theorem b_positive_defined :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (n : nat), (n >= 1)%nat ->
  m1 > 0 /\
  INR (n + 1) <> 0 /\
  m2 > 0 /\
  INR n <> 0.
Proof. exact b_positive.b_positive_defined. Qed.

(* statement sha256 79e7cf5150b0d9c680d5b2e4f7c304873d240d89f75b247881a4a86140a20f88 *)
Theorem p_inelastic :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (n : nat), (n >= 1)%nat ->
  let S := fun (k : nat) => Rpower m1 (1 / INR k) + Rpower m2 (1 / INR k) in
  let eta := fun (k : nat) => m1 * m2 / S k ^ (2 * k) in
  eta (n + 1)%nat < eta n.
Proof. exact p_inelastic.p_inelastic. Qed.

Theorem p_inelastic_defined :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (n : nat), (n >= 1)%nat ->
  Rpower m1 (1 / INR (n + 1)) + Rpower m2 (1 / INR (n + 1)) <> 0 /\
  m1 > 0 /\
  INR (n + 1) <> 0 /\
  m2 > 0 /\
  Rpower m1 (1 / INR n) + Rpower m2 (1 / INR n) <> 0 /\
  INR n <> 0.
Proof. exact p_inelastic.p_inelastic_defined. Qed.

(* statement sha256 250084fc6a40b86ddabaf7255653e889df2435d3ba1673124705f75efd2bd5a3 *)
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
Proof. exact p_loss.p_loss. Qed.

Theorem p_loss_defined :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  forall (v1 v2 w1 w2 : R),
  m1 * v1 + m2 * v2 = m1 * w1 + m2 * w2 ->
  w2 - w1 = - (e * (v2 - v1)) ->
  m1 + m2 <> 0.
Proof. exact p_loss.p_loss_defined. Qed.

(* statement sha256 eb94d6be1c850b51d2bc4c5be937b35cfd3b257628525c056d3750fd7fe33753 *)
Theorem p_order :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  forall (v1 v2 w1 w2 : R),
  m1 * v1 + m2 * v2 = m1 * w1 + m2 * w2 ->
  w2 - w1 = - (e * (v2 - v1)) ->
  v1 >= v2 ->
  w1 <= w2.
Proof. exact p_order.p_order. Qed.

(* statement sha256 1d62bc513013f72750b85c92fa11e6b6008d28ed9a232e70a2b3db8ded6fc7d3 *)
Theorem p_rest :
  forall (x v1 : R), x > 0 -> v1 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  forall (i : nat),
  ((x - e) / (x + 1) * v1 = 0 <-> x = e) /\
  ((x * (1 + e)) ^ i * (x - e) / (x + 1) ^ (i + 1) * v1 = 0 <-> x = e).
Proof. exact p_rest.p_rest. Qed.

Theorem p_rest_defined :
  forall (x v1 : R), x > 0 -> v1 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  forall (i : nat),
  x + 1 <> 0.
Proof. exact p_rest.p_rest_defined. Qed.

(* statement sha256 26ba43dd8b3b92a8c685ecee6a3642e2736daac5c42f5fc546b75b42f9a45209 *)
Theorem p_stop :
  forall (m1 m2 v1 : R), m1 > 0 -> m2 > 0 -> v1 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  let w1 := (m1 - e * m2) / (m1 + m2) * v1 in
  let eta := (1 + e) ^ 2 * m1 * m2 / (m1 + m2) ^ 2 in
  (w1 = 0 <-> m1 = e * m2) /\
  (m1 = e * m2 -> eta = e) /\
  e <= (1 + e) ^ 2 / 4 /\
  (e = (1 + e) ^ 2 / 4 <-> e = 1).
Proof. exact p_stop.p_stop. Qed.

Theorem p_stop_defined :
  forall (m1 m2 v1 : R), m1 > 0 -> m2 > 0 -> v1 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  m1 + m2 <> 0.
Proof. exact p_stop.p_stop_defined. Qed.

(* statement sha256 30c5faf4b6c836c0ca8fa8bf0595fa895d4232f6aba2b7a3f639ff3e5af1f919 *)
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
Proof. exact p_two.p_two. Qed.

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
Proof. exact p_two.p_two_defined. Qed.

(* statement sha256 b8d95ec905cbe6e1096b6b5f19d16086050eda5baf5e8beb58622f119324b6f5 *)
Theorem p_two_converse :
  ~ (
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  let L2 := (cbrt m1 + cbrt m2) ^ 3 / (sqrt m1 + sqrt m2) ^ 2 - 1 in
  let eta2 := (1 + e) ^ 2 * m1 * m2 / (m1 + m2) ^ 2 in
  let eta4 := (1 + e) ^ 6 * m1 * m2 / (cbrt m1 + cbrt m2) ^ 6 in
  eta4 >= eta2 -> e >= L2).
Proof. exact p_two_converse.p_two_converse. Qed.

(* statement sha256 8681ee5228371cc9cc4610bb0dbf97627f776bf8494f442f6d7061307982eb30 *)
Theorem u1 :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  forall (v1 v2 w1 w2 : R),
  m1 * v1 + m2 * v2 = m1 * w1 + m2 * w2 ->
  w2 - w1 = - (e * (v2 - v1)) ->
  w2 = w1 - e * (v2 - v1) /\
  m1 * v1 + m2 * v2 = (m1 + m2) * w1 - e * m2 * (v2 - v1).
Proof. exact u1.u1. Qed.

(* statement sha256 67bb455e705ebb14da030a0eba0a5bee6616856f3ddec0b4f2e0f858dac87d97 *)
Theorem u2 :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  forall (v1 : R),
  let w2 := m1 * (1 + e) / (m1 + m2) * v1 in
  let K1 := m1 * v1 ^ 2 / 2 in
  m2 * w2 ^ 2 / 2 = m2 / 2 * (m1 * (1 + e) / (m1 + m2)) ^ 2 * v1 ^ 2 /\
  m2 * w2 ^ 2 / 2 = (1 + e) ^ 2 * m1 * m2 / (m1 + m2) ^ 2 * K1.
Proof. exact u2.u2. Qed.

Theorem u2_defined :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  forall (v1 : R),
  m1 + m2 <> 0.
Proof. exact u2.u2_defined. Qed.

(* statement sha256 5b8e465c4939e6b43c1811912e058d4d1e11624f34adb3ccf80a1b7ea3e49855 *)
Theorem u3 :
  forall (x : R), x > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  is_derive (fun x : R => (1 + e) ^ 2 * x / (1 + x) ^ 2) x ((1 + e) ^ 2 * ((1 + x) ^ 2 - 2 * x * (1 + x)) /
      (1 + x) ^ 4) /\
  is_derive (fun x : R => (1 + e) ^ 2 * x / (1 + x) ^ 2) x ((1 + e) ^ 2 * (1 - x) / (1 + x) ^ 3).
Proof. exact u3.u3. Qed.

Theorem u3_defined :
  forall (x : R), x > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  ex_derive (fun x : R => (1 + e) ^ 2 * x / (1 + x) ^ 2) x /\
  1 + x <> 0.
Proof. exact u3.u3_defined. Qed.

(* statement sha256 d224db667f719196e40643423a474ea50f04564ea47af56bbd0e2aa4f53a3073 *)
Theorem u4 :
  forall (m1 mu : R), m1 > 0 -> mu > 0 ->
  forall (e1 : R), 0 <= e1 <= 1 ->
  forall (v1 v w1 w : R),
  m1 * v1 + mu * v = m1 * w1 + mu * w ->
  w - w1 = - (e1 * (v - v1)) ->
  [[w1]; [w]] = mat_scale (1 / (m1 + mu)) (mat_mul [[m1 - e1 * mu; mu * (1 + e1)]; [m1 * (1 + e1); mu - e1 *
      m1]] [[v1]; [v]]).
Proof. exact u4.u4. Qed.

Theorem u4_defined :
  forall (m1 mu : R), m1 > 0 -> mu > 0 ->
  forall (e1 : R), 0 <= e1 <= 1 ->
  forall (v1 v w1 w : R),
  m1 * v1 + mu * v = m1 * w1 + mu * w ->
  w - w1 = - (e1 * (v - v1)) ->
  m1 + mu <> 0.
Proof. exact u4.u4_defined. Qed.

(* statement sha256 8c015ba2d60793b7d2456f6d9a5482b91889e893788255f028a8f48c91a964db *)
Theorem u5 :
  forall (m1 m2 mu : R), m1 > 0 -> m2 > 0 -> mu > 0 ->
  forall (e1 e2 : R), 0 <= e1 <= 1 -> 0 <= e2 <= 1 ->
  let k1 := 2 * (1 + e1) ^ 2 * (1 + e2) ^ 2 * m1 * m2 in
  is_derive (fun mu : R => (1 + e1) ^ 2 * (1 + e2) ^ 2 * m1 * m2 * mu ^ 2 / ((m1 + mu) ^ 2 * (mu +
      m2) ^ 2)) mu (k1 * mu * ((m1 + mu) * (mu + m2) - mu * (m1 + m2 + 2 * mu)) / ((m1 + mu) ^ 3 * (mu +
      m2) ^ 3)) /\
  is_derive (fun mu : R => (1 + e1) ^ 2 * (1 + e2) ^ 2 * m1 * m2 * mu ^ 2 / ((m1 + mu) ^ 2 * (mu +
      m2) ^ 2)) mu (k1 * mu * (m1 * m2 - mu ^ 2) / ((m1 + mu) ^ 3 * (mu + m2) ^ 3)).
Proof. exact u5.u5. Qed.

Theorem u5_defined :
  forall (m1 m2 mu : R), m1 > 0 -> m2 > 0 -> mu > 0 ->
  forall (e1 e2 : R), 0 <= e1 <= 1 -> 0 <= e2 <= 1 ->
  ex_derive (fun mu : R => (1 + e1) ^ 2 * (1 + e2) ^ 2 * m1 * m2 * mu ^ 2 / ((m1 + mu) ^ 2 * (mu +
      m2) ^ 2)) mu /\
  m1 + mu <> 0 /\
  mu + m2 <> 0.
Proof. exact u5.u5_defined. Qed.

(* statement sha256 9ba71ad9af551b48d673fbaaec852ed8261241ae9b606572a9ed73748ea5d497 *)
Theorem u5_extracted :
  ~ (
  forall (m2 mu x : R), m2 > 0 -> mu > 0 -> x > 0 ->
  forall (e1 e2 : R), 0 <= e1 <= 1 -> 0 <= e2 <= 1 ->
  let m1 := x * m2 in
  let k1 := 2 * (1 + e1) ^ 2 * (1 + e2) ^ 2 * m1 * m2 in
  is_derive (fun x : R => (1 + e1) ^ 2 * (1 + e2) ^ 2 * (x * m2) * m2 * mu ^ 2 / ((x * m2 + mu) ^ 2 * (mu +
      m2) ^ 2)) x (k1 * mu * (m1 * m2 - mu ^ 2) / ((m1 + mu) ^ 3 * (mu + m2) ^ 3))).
Proof. exact u5_extracted.u5_extracted. Qed.

(* statement sha256 6e294f5ee2106fd906e96ff818fb44453ab98cb6d58c655977381de4c9f7c5bf *)
Theorem u6 :
  forall (m1 m2 mu : R), m1 > 0 -> m2 > 0 -> mu > 0 ->
  forall (e1 e2 : R), 0 <= e1 <= 1 -> 0 <= e2 <= 1 ->
  let k1 := 2 * (1 + e1) ^ 2 * (1 + e2) ^ 2 * m1 * m2 in
  let second := fun (t : R) => k1 * ((m1 * m2 - 3 * t ^ 2) * (m1 + t) * (t + m2) - 3 * t * (m1 * m2 - t ^ 2) *
      (m1 + m2 + 2 * t)) / ((m1 + t) ^ 4 * (t + m2) ^ 4) in
  is_derive_n (fun mu : R => (1 + e1) ^ 2 * (1 + e2) ^ 2 * m1 * m2 * mu ^ 2 / ((m1 + mu) ^ 2 * (mu +
      m2) ^ 2)) 2 mu (second mu) /\
  second (sqrt (m1 * m2)) < 0.
Proof. exact u6.u6. Qed.

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
Proof. exact u6.u6_defined. Qed.

(* statement sha256 b36a39892c258233ab2967c17e5ae8328aaf67eb838e597b04846b35e399601d *)
Theorem u7 :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  let eta2 := fun (e : R) => (1 + e) ^ 2 * m1 * m2 / (m1 + m2) ^ 2 in
  let eta3 := fun (e : R) => (1 + e) ^ 4 * m1 * m2 / (sqrt m1 + sqrt m2) ^ 4 in
  eta2 1 = 4 * m1 * m2 / (m1 + m2) ^ 2 /\
  eta3 1 = 16 * m1 * m2 / (sqrt m1 + sqrt m2) ^ 4 /\
  eta3 1 / eta2 1 = 4 * (m1 + m2) ^ 2 / (sqrt m1 + sqrt m2) ^ 4.
Proof. exact u7.u7. Qed.

Theorem u7_defined :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  m1 + m2 <> 0 /\
  sqrt m1 + sqrt m2 <> 0 /\
  0 <= m1 /\
  0 <= m2 /\
  INR (1 + 1) <> 0 /\
  m1 <> 0 /\
  m2 <> 0.
Proof. exact u7.u7_defined. Qed.

(* statement sha256 fac91251ba0d23e2d7c9a82c83bbd72a4bf73076a6d5b1a062eb14adb09685d7 *)
Theorem u8 :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  let ratio := 4 * (m1 + m2) ^ 2 / (sqrt m1 + sqrt m2) ^ 4 in
  sqrt ratio - 1 = ((sqrt m1 - sqrt m2) / (sqrt m1 + sqrt m2)) ^ 2 /\
  sqrt ratio - 1 >= 0.
Proof. exact u8.u8. Qed.

Theorem u8_defined :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  0 <= 4 * (m1 + m2) ^ 2 / (sqrt m1 + sqrt m2) ^ 4 /\
  sqrt m1 + sqrt m2 <> 0 /\
  0 <= m1 /\
  0 <= m2.
Proof. exact u8.u8_defined. Qed.

(* statement sha256 3aafc84326c1c4ce7af4700c5447ec0d2e1f2bc5b4a82de26a9e762501303735 *)
Theorem u8_extracted :
  ~ (
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  let ratio := 4 * (m1 + m2) ^ 2 / (sqrt m1 + sqrt m2) ^ 4 in
  ratio - 1 = ((sqrt m1 - sqrt m2) / (sqrt m1 + sqrt m2)) ^ 2).
Proof. exact u8_extracted.u8_extracted. Qed.

(* statement sha256 a92ceb143934ac1dd68fe4d164f3b2ed4f3d0e8ecc49de92cdea0f345e95b94b *)
Theorem u9 :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  let ratio := (m1 + m2) ^ 2 / (sqrt m1 + sqrt m2) ^ 4 in
  sqrt ratio - 1 = - (2 * sqrt (m1 * m2) / (sqrt m1 + sqrt m2) ^ 2) /\
  sqrt ratio - 1 <= 0.
Proof. exact u9.u9. Qed.

Theorem u9_defined :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  0 <= (m1 + m2) ^ 2 / (sqrt m1 + sqrt m2) ^ 4 /\
  sqrt m1 + sqrt m2 <> 0 /\
  0 <= m1 /\
  0 <= m2 /\
  0 <= m1 * m2.
Proof. exact u9.u9_defined. Qed.

(* statement sha256 346039342b50f0f53f4c7b872c64d0271ac1aea2f42c001aa44f347f6c571e92 *)
Theorem u9_extracted :
  ~ (
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  let ratio := (m1 + m2) ^ 2 / (sqrt m1 + sqrt m2) ^ 4 in
  ratio - 1 = - (2 * sqrt (m1 * m2) / (sqrt m1 + sqrt m2) ^ 2)).
Proof. exact u9_extracted.u9_extracted. Qed.

(* statement sha256 66ca054b661727c1e18c962785056d552050fa4e3faadeefc891096a01a25cde *)
Theorem u10 :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e e1 e2 : R), 0 <= e <= 1 -> 0 <= e1 <= 1 -> 0 <= e2 <= 1 ->
  let eta2 := (1 + e) ^ 2 * m1 * m2 / (m1 + m2) ^ 2 in
  let eta3 := (1 + e1) ^ 2 * (1 + e2) ^ 2 * m1 * m2 / (sqrt m1 + sqrt m2) ^ 4 in
  eta3 >= eta2 <-> (1 + e1) * (1 + e2) * (m1 + m2) >= (1 + e) * (sqrt m1 + sqrt m2) ^ 2.
Proof. exact u10.u10. Qed.

Theorem u10_defined :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e e1 e2 : R), 0 <= e <= 1 -> 0 <= e1 <= 1 -> 0 <= e2 <= 1 ->
  sqrt m1 + sqrt m2 <> 0 /\
  0 <= m1 /\
  0 <= m2 /\
  m1 + m2 <> 0.
Proof. exact u10.u10_defined. Qed.

(* statement sha256 2c011cf4ee183585a1a7529d39524355c4a17b78afd070076d39177683a07991 *)
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
Proof. exact u11.u11. Qed.

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
Proof. exact u11.u11_defined. Qed.

(* statement sha256 80bafbf709efefc39ed1dd8e316071427dee86bbfd0107c6a8ef8d09eaf91dc8 *)
Theorem u12 :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  let eta3 := (1 + e) ^ 4 * m1 * m2 / (sqrt m1 + sqrt m2) ^ 4 in
  let eta4 := (1 + e) ^ 6 * m1 * m2 / (cbrt m1 + cbrt m2) ^ 6 in
  eta4 / eta3 = (1 + e) ^ 2 * (sqrt m1 + sqrt m2) ^ 4 / (cbrt m1 + cbrt m2) ^ 6 /\
  (eta4 >= eta3 <-> (1 + e) * (sqrt m1 + sqrt m2) ^ 2 >= (cbrt m1 + cbrt m2) ^ 3).
Proof. exact u12.u12. Qed.

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
Proof. exact u12.u12_defined. Qed.

(* statement sha256 30e80ded357d1a8004fcc06794a2522513d7678447f703d467bd78a3f07295e8 *)
Theorem u13 :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  let x := m1 / m2 in
  let first := (sqrt m1 + sqrt m2) ^ 2 / (m1 + m2) in
  let second := (cbrt m1 + cbrt m2) ^ 3 / (sqrt m1 + sqrt m2) ^ 2 in
  second / first = (cbrt m1 + cbrt m2) ^ 3 * (m1 + m2) / (sqrt m1 + sqrt m2) ^ 4 /\
  second / first = (cbrt x + 1) ^ 3 * (x + 1) / (sqrt x + 1) ^ 4 /\
  second / first >= 1 /\
  (second / first = 1 <-> m1 = m2).
Proof. exact u13.u13. Qed.

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
Proof. exact u13.u13_defined. Qed.

(* statement sha256 351979680b7faf9afe415cda928edc5d8041636c31ef17737a0ee5c88790de01 *)
Theorem b_grow :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (n : nat), (n >= 1)%nat ->
  let S := fun (k : nat) => Rpower m1 (1 / INR k) + Rpower m2 (1 / INR k) in
  let L := fun (k : nat) => S (k + 1)%nat ^ (k + 1) / S k ^ k - 1 in
  L (n + 1)%nat >= L n /\
  (m1 <> m2 -> L (n + 1)%nat > L n).
Proof. exact b_grow.b_grow. Qed.

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
Proof. exact b_grow.b_grow_defined. Qed.

(* statement sha256 3e9ebcfaa9f392aeb3a35250d31f03b836220ee1538829733dd54a26e1ef6f3f *)
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
Proof. exact b_best.b_best. Qed.

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
Proof. exact b_best.b_best_defined. Qed.

(* statement sha256 ae81be318d83cfcacfca751cfefa5889ffd107873c594c68d9b03abf9b8574cb *)
Theorem b_best_after :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  forall (N : nat), (N >= 1)%nat ->
  forall (j : nat),
  let S := fun (k : nat) => Rpower m1 (1 / INR k) + Rpower m2 (1 / INR k) in
  let L := fun (k : nat) => S (k + 1)%nat ^ (k + 1) / S k ^ k - 1 in
  e < L N ->
  e < L (N + j)%nat.
Proof. exact b_best_after.b_best_after. Qed.

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
Proof. exact b_best_after.b_best_after_defined. Qed.

(* statement sha256 5c6bcef74275eefc75c3cd783f92b3f7b8e0902deea365e395638a8e779a7c84 *)
Theorem b_best_elastic :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (n : nat), (n >= 1)%nat ->
  let S := fun (k : nat) => Rpower m1 (1 / INR k) + Rpower m2 (1 / INR k) in
  let L := S (n + 1)%nat ^ (n + 1) / S n ^ n - 1 in
  (m1 <> m2 -> L < 1) /\
  (m1 = m2 -> L = 1).
Proof. exact b_best_elastic.b_best_elastic. Qed.

Theorem b_best_elastic_defined :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (n : nat), (n >= 1)%nat ->
  Rpower m1 (1 / INR n) + Rpower m2 (1 / INR n) <> 0 /\
  m1 > 0 /\
  INR (n + 1) <> 0 /\
  m2 > 0 /\
  INR n <> 0.
Proof. exact b_best_elastic.b_best_elastic_defined. Qed.

(* statement sha256 a7fc08db7905ad3c967cddc7c0777726805ba1b643f39da48279e93a4639bcd2 *)
Theorem lemma_bernoulli :
  forall (h : R), h > - 1 ->
  forall (n : nat),
  (1 + h) ^ n >= 1 + INR n * h.
Proof. exact lemma_bernoulli.lemma_bernoulli. Qed.

(* statement sha256 e71e33eb81226457b84f00ce6920566a3a7a9bfd42fd5dbe16adde06ff17a50e *)
Theorem lemma_elastic_bound :
  forall (r : R), r > 0 ->
  forall (n : nat), (n >= 1)%nat ->
  let t := Rpower r (1 / INR n) in
  let eta := (4 * t / (1 + t) ^ 2) ^ n in
  eta <= 1 /\
  (r >= 1 -> eta >= 1 - (r - 1) ^ 2 / INR n) /\
  (r <= 1 -> eta >= 1 - (1 / r - 1) ^ 2 / INR n).
Proof. exact lemma_elastic_bound.lemma_elastic_bound. Qed.

Theorem lemma_elastic_bound_defined :
  forall (r : R), r > 0 ->
  forall (n : nat), (n >= 1)%nat ->
  1 + Rpower r (1 / INR n) <> 0 /\
  r > 0 /\
  INR n <> 0 /\
  r <> 0.
Proof. exact lemma_elastic_bound.lemma_elastic_bound_defined. Qed.

(* statement sha256 25e1352b43dfe0302bb010978a15b7c6e2bbaa88f9b7847a92ac877dae89c404 *)
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
Proof. exact b_best_finite.b_best_finite. Qed.

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
Proof. exact b_best_finite.b_best_finite_defined. Qed.

(* statement sha256 1a0cbae6ba8cb776314a0017d6f3c2ffd42b91347f9d9a41818da4ac08f079bc *)
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
Proof. exact b_budget.b_budget. Qed.

Theorem b_budget_defined :
  forall (mu : nat -> R), (forall k : nat, mu k > 0) ->
  forall (e : nat -> R), (forall k : nat, 0 <= e k <= 1) ->
  forall (v1 : R),
  forall (n : nat),
  forall u : nat -> R, u 0%nat = v1 ->
  (forall k : nat, u (k + 1)%nat = mu k * (1 + e k) / (mu k + mu (k + 1)%nat) * u k) ->
  (forall k : nat, mu k + mu (k + 1)%nat <> 0) /\
  (forall k : nat, (0 <= k <= n)%nat -> mu k + mu (k + 1)%nat <> 0).
Proof. exact b_budget.b_budget_defined. Qed.

(* statement sha256 dc6ea689c8071b26c6079596893b8e9b335c936146c63c85d5c8a7c95c5b4de5 *)
Theorem b_closed :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  forall (n : nat), (n >= 1)%nat ->
  let d := ln (m1 / m2) / 2 in
  let S := fun (k : nat) => Rpower m1 (1 / INR k) + Rpower m2 (1 / INR k) in
  (1 + e) ^ (2 * (n + 1)) * m1 * m2 / S (n + 1)%nat ^ (2 * (n + 1)) =
      ((1 + e) / 2 * sech (d / INR (n + 1))) ^ (2 * (n + 1)) /\
  S (n + 1)%nat ^ (n + 1) / S n ^ n - 1 = 2 * cosh (d / INR (n + 1)) ^ (n + 1) / cosh (d / INR n) ^ n - 1.
Proof. exact b_closed.b_closed. Qed.

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
Proof. exact b_closed.b_closed_defined. Qed.

(* statement sha256 377e297edb3b77d6d5c362fb68fec24f0672f4f22abbc348d8d1e3f5b04495b4 *)
Theorem b_final :
  forall (x : R), x > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  forall (n : nat), (n >= 1)%nat ->
  let L := (1 + x) ^ (n + 1) / (1 + Rpower x (INR (n + 1) / INR n)) ^ n - 1 in
  e >= L ->
  x <= e \/ x * e >= 1.
Proof. exact b_final.b_final. Qed.

(* statement sha256 a988c4e2522221ca0eca7b6a89d5c95120f9cb80436c93f7967701e75f85ddf8 *)
Theorem lemma_chain :
  forall (mu : nat -> R), (forall k : nat, mu k > 0) ->
  forall (r : R), r > 0 ->
  forall (n : nat),
  let p := r / (1 + r) in
  product_over 0 n (fun i : nat => mu i + mu (i + 1)%nat) * Rpower (mu 0%nat) p * Rpower r (p * INR (n +
      1)) >= product_over 0 n (fun i : nat => mu i) * (1 + r) ^ (n + 1) * Rpower (mu (n + 1)%nat) p.
Proof. exact lemma_chain.lemma_chain. Qed.

Theorem lemma_chain_defined :
  forall (mu : nat -> R), (forall k : nat, mu k > 0) ->
  forall (r : R), r > 0 ->
  forall (n : nat),
  mu 0%nat > 0 /\
  1 + r <> 0 /\
  r > 0 /\
  mu (n + 1)%nat > 0.
Proof. exact lemma_chain.lemma_chain_defined. Qed.

(* statement sha256 298170edd4218f96b8e62cac877e97f32dbdbc19c176b3d4b2bc87d1448a5dd0 *)
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
Proof. exact b_global.b_global. Qed.

Theorem b_global_defined :
  forall (mu : nat -> R), (forall k : nat, mu k > 0) ->
  forall (e : nat -> R), (forall k : nat, 0 <= e k <= 1) ->
  forall (n : nat), (n >= 1)%nat ->
  product_over 0 n (fun i : nat => mu i + mu (i + 1)%nat) <> 0 /\
  Rpower (mu 0%nat) (1 / INR (n + 1)) + Rpower (mu (n + 1)%nat) (1 / INR (n + 1)) <> 0 /\
  mu 0%nat > 0 /\
  INR (n + 1) <> 0 /\
  mu (n + 1)%nat > 0.
Proof. exact b_global.b_global_defined. Qed.

(* statement sha256 0ef886400f65fd7bc9fd7059ce798ceb2392c01f39670caf7612b7e6f22e2270 *)
Theorem lemma_chain_last :
  forall (mu : nat -> R), (forall k : nat, mu k > 0) ->
  forall (r : R), r > 0 ->
  forall (j : nat),
  let p := r / (1 + r) in
  mu (j + 1)%nat <> mu j * r -> product_over 0 j (fun i : nat => mu i + mu (i + 1)%nat) *
      Rpower (mu 0%nat) p * Rpower r (p * INR (j + 1)) >
      product_over 0 j (fun i : nat => mu i) * (1 + r) ^ (j + 1) * Rpower (mu (j + 1)%nat) p.
Proof. exact lemma_chain_last.lemma_chain_last. Qed.

Theorem lemma_chain_last_defined :
  forall (mu : nat -> R), (forall k : nat, mu k > 0) ->
  forall (r : R), r > 0 ->
  forall (j : nat),
  mu 0%nat > 0 /\
  1 + r <> 0 /\
  r > 0 /\
  mu (j + 1)%nat > 0.
Proof. exact lemma_chain_last.lemma_chain_last_defined. Qed.

(* statement sha256 59bbbef0eaa0614fb4c28f88d055fcc79e9c181b8261e0a4d4185086b3f561a5 *)
Theorem lemma_chain_strict :
  forall (mu : nat -> R), (forall i : nat, mu i > 0) ->
  forall (r : R), r > 0 ->
  forall (j k : nat),
  let p := r / (1 + r) in
  mu (j + 1)%nat <> mu j * r ->
  product_over 0 (j + k) (fun i : nat => mu i + mu (i + 1)%nat) * Rpower (mu 0%nat) p * Rpower r (p * INR (j +
      k + 1)) > product_over 0 (j + k) (fun i : nat => mu i) * (1 + r) ^ (j + k + 1) * Rpower (mu (j + k +
      1)%nat) p.
Proof. exact lemma_chain_strict.lemma_chain_strict. Qed.

Theorem lemma_chain_strict_defined :
  forall (mu : nat -> R), (forall i : nat, mu i > 0) ->
  forall (r : R), r > 0 ->
  forall (j k : nat),
  mu (j + 1)%nat <> mu j * r ->
  mu 0%nat > 0 /\
  1 + r <> 0 /\
  r > 0 /\
  mu (j + k + 1)%nat > 0.
Proof. exact lemma_chain_strict.lemma_chain_strict_defined. Qed.

(* statement sha256 94d13b8563216d7de70298bdf7bb84abf0cc3c713a908b4574846cfcb4f6e92b *)
Theorem b_global_unique :
  forall (mu : nat -> R), (forall i : nat, mu i > 0) ->
  forall (j k : nat),
  let n := (j + k)%nat in
  let N := (n + 1)%nat in
  let m1 := mu 0%nat in
  let m2 := mu (n + 1)%nat in
  forall (e : nat -> R), (forall i : nat, 0 <= e i <= 1) ->
  let eta := product_over 0 n (fun i : nat => (1 + e i) ^ 2) * m1 * m2 *
      product_over 1 n (fun i : nat => mu i) ^ 2 / product_over 0 n (fun i : nat => mu i + mu (i +
      1)%nat) ^ 2 in
  let best := product_over 0 n (fun i : nat => (1 + e i) ^ 2) * m1 * m2 / (Rpower m1 (1 / INR N) +
      Rpower m2 (1 / INR N)) ^ (2 * N) in
  mu (j + 1)%nat <> mu j * Rpower (m2 / m1) (1 / INR N) ->
  eta < best.
Proof. exact b_global_unique.b_global_unique. Qed.

Theorem b_global_unique_defined :
  forall (mu : nat -> R), (forall i : nat, mu i > 0) ->
  forall (j k : nat),
  forall (e : nat -> R), (forall i : nat, 0 <= e i <= 1) ->
  mu (j + 1)%nat <> mu j * Rpower (mu ((j + k) + 1)%nat / mu 0%nat) (1 / INR ((j + k) + 1)) ->
  product_over 0 (j + k) (fun i : nat => mu i + mu (i + 1)%nat) <> 0 /\
  Rpower (mu 0%nat) (1 / INR ((j + k) + 1)) + Rpower (mu ((j + k) + 1)%nat) (1 / INR ((j + k) + 1)) <> 0 /\
  mu 0%nat > 0 /\
  INR ((j + k) + 1) <> 0 /\
  mu ((j + k) + 1)%nat > 0.
Proof. exact b_global_unique.b_global_unique_defined. Qed.

(* statement sha256 e8f8401ea57b1b9954cbfc95718828d95e6f5cad3550cc051c3dd7e4ef66c01f *)
Theorem b_grow_limit :
  forall (m2 r : R), m2 > 0 -> r > 0 ->
  forall (n : nat), (n >= 1)%nat ->
  is_lim_seq (fun n : nat => (Rpower (r * m2) (1 / INR (n + 1)) + Rpower m2 (1 / INR (n + 1))) ^ (n + 1) /
      (Rpower (r * m2) (1 / INR n) + Rpower m2 (1 / INR n)) ^ n - 1) 1.
Proof. exact b_grow_limit.b_grow_limit. Qed.

Theorem b_grow_limit_defined :
  forall (m2 r : R), m2 > 0 -> r > 0 ->
  forall (n : nat), (n >= 1)%nat ->
  Rpower (r * m2) (1 / INR n) + Rpower m2 (1 / INR n) <> 0 /\
  r * m2 > 0 /\
  INR (n + 1) <> 0 /\
  m2 > 0 /\
  INR n <> 0.
Proof. exact b_grow_limit.b_grow_limit_defined. Qed.

(* statement sha256 af3df9e0328a63372a6b538e4071ecc7ffe87167331b8fae2f746fb816943b96 *)
Theorem b_insert :
  forall (a b mu : R), a > 0 -> b > 0 -> mu > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  let through := (1 + e) ^ 4 * a * b * mu ^ 2 / ((a + mu) ^ 2 * (mu + b) ^ 2) in
  let direct := (1 + e) ^ 2 * a * b / (a + b) ^ 2 in
  let tau := (a * b + mu ^ 2) / (mu * (a + b)) in
  (through >= direct <-> e >= tau) /\
  (through = direct <-> e = tau) /\
  1 - tau = (mu - a) * (b - mu) / (mu * (a + b)).
Proof. exact b_insert.b_insert. Qed.

Theorem b_insert_defined :
  forall (a b mu : R), a > 0 -> b > 0 -> mu > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  a + mu <> 0 /\
  mu + b <> 0 /\
  a + b <> 0 /\
  mu <> 0.
Proof. exact b_insert.b_insert_defined. Qed.

(* statement sha256 64ccfeb7338fbc9ede39b0850c5446d4b46f77eec621af95a64eec9eba6d0003 *)
Theorem b_insert_each :
  forall (a b mu : R), a > 0 -> b > 0 -> mu > 0 ->
  forall (p q d : R), 0 <= p <= 1 -> 0 <= q <= 1 -> 0 <= d <= 1 ->
  let through := (1 + p) ^ 2 * (1 + q) ^ 2 * a * b * mu ^ 2 / ((a + mu) ^ 2 * (mu + b) ^ 2) in
  let direct := (1 + d) ^ 2 * a * b / (a + b) ^ 2 in
  let tau := (a * b + mu ^ 2) / (mu * (a + b)) in
  (through >= direct <-> (1 + p) * (1 + q) / (1 + d) >= 1 + tau) /\
  (through = direct <-> (1 + p) * (1 + q) / (1 + d) = 1 + tau).
Proof. exact b_insert_each.b_insert_each. Qed.

Theorem b_insert_each_defined :
  forall (a b mu : R), a > 0 -> b > 0 -> mu > 0 ->
  forall (p q d : R), 0 <= p <= 1 -> 0 <= q <= 1 -> 0 <= d <= 1 ->
  a + mu <> 0 /\
  mu + b <> 0 /\
  a + b <> 0 /\
  1 + d <> 0 /\
  mu <> 0.
Proof. exact b_insert_each.b_insert_each_defined. Qed.

(* statement sha256 c4dc3e303ee61db12017f126a95155ff8892d61e79104c465bea77a2e2482ec3 *)
Theorem b_limit :
  forall (m2 r : R), m2 > 0 -> r > 0 ->
  forall (n : nat), (n >= 1)%nat ->
  is_lim_seq (fun n : nat => 4 ^ n * (r * m2) * m2 / (Rpower (r * m2) (1 / INR n) + Rpower m2 (1 /
      INR n)) ^ (2 * n)) 1.
Proof. exact b_limit.b_limit. Qed.

Theorem b_limit_defined :
  forall (m2 r : R), m2 > 0 -> r > 0 ->
  forall (n : nat), (n >= 1)%nat ->
  Rpower (r * m2) (1 / INR n) + Rpower m2 (1 / INR n) <> 0 /\
  r * m2 > 0 /\
  INR n <> 0 /\
  m2 > 0.
Proof. exact b_limit.b_limit_defined. Qed.

(* statement sha256 e3d0b514fc6dbb496328a067251cff2dfe8edc97822313480613a2557c0a30d6 *)
Theorem b_limit_inelastic :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e < 1 ->
  forall (n : nat), (n >= 1)%nat ->
  is_lim_seq (fun n : nat => (1 + e) ^ (2 * n) * m1 * m2 / (Rpower m1 (1 / INR n) + Rpower m2 (1 /
      INR n)) ^ (2 * n)) 0.
Proof. exact b_limit_inelastic.b_limit_inelastic. Qed.

Theorem b_limit_inelastic_defined :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e < 1 ->
  forall (n : nat), (n >= 1)%nat ->
  Rpower m1 (1 / INR n) + Rpower m2 (1 / INR n) <> 0 /\
  m1 > 0 /\
  INR n <> 0 /\
  m2 > 0.
Proof. exact b_limit_inelastic.b_limit_inelastic_defined. Qed.

(* statement sha256 0b88566649296ffc5939704ecac6dd534719dfdc16dcdc84c149df266c056e7f *)
Theorem b_matrix :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  let M := mat_scale (1 / (m1 + m2)) [[m1 - e * m2; m2 * (1 + e)]; [m1 * (1 + e); m2 - e * m1]] in
  let I_ := [[1; 0]; [0; 1]] in
  det2 M = - e /\
  det2 (mat_add M (mat_scale (- 1) I_)) = 0 /\
  det2 (mat_add M (mat_scale e I_)) = 0 /\
  mat_mul (mat_add M (mat_scale (- 1) I_)) (mat_add M (mat_scale e I_)) = mat_scale 0 I_ /\
  mat_mul M [[1]; [1]] = [[1]; [1]] /\
  mat_mul M [[- m2]; [m1]] = mat_scale (- 1) (mat_scale e [[- m2]; [m1]]).
Proof. exact b_matrix.b_matrix. Qed.

Theorem b_matrix_defined :
  forall (m1 m2 : R), m1 > 0 -> m2 > 0 ->
  forall (e : R), 0 <= e <= 1 ->
  m1 + m2 <> 0.
Proof. exact b_matrix.b_matrix_defined. Qed.

(* statement sha256 e064c4bd0ce543bdc5726daea4181b7eda703617c1d9113b811aaebfb577610e *)
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
Proof. exact b_power.b_power. Qed.

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
Proof. exact b_power.b_power_defined. Qed.

(* statement sha256 3a1a2aa35b336f093fc24fb473a86343d17dbe62f72f63100dc6512d5ebde0fa *)
Theorem b_power_attained :
  forall (w : R), w > 1 ->
  forall (m2 N : R), m2 > 0 -> N > 0 ->
  let u := ln w / 2 in
  let e := 2 * cosh u / exp (u * tanh u) - 1 in
  let m1 := m2 * Rpower w N in
  let eta := Rpower (1 + e) (2 * N) * m1 * m2 / Rpower (Rpower m1 (1 / N) + Rpower m2 (1 / N)) (2 * N) in
  N = ln (m1 / m2) / (2 * u) /\
  eta = Rpower (m2 / m1) (tanh u).
Proof. exact b_power_attained.b_power_attained. Qed.

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
Proof. exact b_power_attained.b_power_attained_defined. Qed.

(* statement sha256 09351b22e8a5622e6bb55067959eaf26cb10075a8d78fa08173e2c5dc16d53a2 *)
Theorem b_power_range :
  forall (w : R), w > 1 ->
  forall (t : R), t > 0 ->
  let u := ln w / 2 in
  let e := 2 * cosh u / exp (u * tanh u) - 1 in
  (0 < e /\ e < 1) /\
  is_derive (fun t : R => t * tanh t - ln (cosh t)) t (t * sech t ^ 2) /\
  t * sech t ^ 2 > 0.
Proof. exact b_power_range.b_power_range. Qed.

Theorem b_power_range_defined :
  forall (w : R), w > 1 ->
  forall (t : R), t > 0 ->
  exp ((ln w / 2) * tanh (ln w / 2)) <> 0 /\
  w > 0 /\
  ex_derive (fun t : R => t * tanh t - ln (cosh t)) t /\
  cosh t > 0.
Proof. exact b_power_range.b_power_range_defined. Qed.

(* statement sha256 6cf4fecd42eda5363b370cf21c3255ed0d5bbaf311363bc6ce3a15b80ddc14d8 *)
Theorem b_superball :
  forall (x : R), x > 0 ->
  forall (e e_f : R), 0 <= e <= 1 -> 0 <= e_f <= 1 ->
  forall (v : R), v > 0 ->
  forall (k : nat),
  forall u : nat -> R, u 0%nat = (1 + e_f) * v ->
  (forall j : nat, u (j + 1)%nat = x * (1 + e) / (x + 1) * u j) ->
  u k - v = ((x * (1 + e) / (x + 1)) ^ k * (1 + e_f) - 1) * v.
Proof. exact b_superball.b_superball. Qed.

Theorem b_superball_defined :
  forall (x : R), x > 0 ->
  forall (e e_f : R), 0 <= e <= 1 -> 0 <= e_f <= 1 ->
  forall (v : R), v > 0 ->
  forall (k : nat),
  forall u : nat -> R, u 0%nat = (1 + e_f) * v ->
  (forall j : nat, u (j + 1)%nat = x * (1 + e) / (x + 1) * u j) ->
  (forall j : nat, x + 1 <> 0) /\
  x + 1 <> 0.
Proof. exact b_superball.b_superball_defined. Qed.

(* statement sha256 255add1e94ba084e030464558bdf662a4e85a1d0c562a190b93ce3e1e2f68692 *)
Theorem b_superball_limit :
  forall (x v g : R), x > 0 -> v > 0 -> g > 0 ->
  is_lim (fun x : R => (2 * x / (x + 1) * 2 * v - v) / v) p_infty 3 /\
  is_lim (fun x : R => ((2 * x / (x + 1) * 2 * v - v) ^ 2 / (2 * g)) / (v ^ 2 / (2 * g))) p_infty 9.
Proof. exact b_superball_limit.b_superball_limit. Qed.

Theorem b_superball_limit_defined :
  forall (x v g : R), x > 0 -> v > 0 -> g > 0 ->
  v <> 0 /\
  x + 1 <> 0 /\
  g <> 0.
Proof. exact b_superball_limit.b_superball_limit_defined. Qed.

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
