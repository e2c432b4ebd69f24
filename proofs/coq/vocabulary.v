(** The words in which statements are exported.

    Everything that a statement in [claims.v] uses is in Coq's library of real numbers, in
    Coquelicot's [is_derive], [is_lim_seq] and [is_lim], or defined here. An auditor reads this file
    and [claims.v]. *)

From Coq Require Export Reals List.
From Coquelicot Require Export Coquelicot.
Export ListNotations.
Open Scope R_scope.

(** The cube root, for positive numbers; [Rpower x y] is exp (y ln x). *)
Definition cbrt (x : R) : R := Rpower x (1 / 3).

(** The hyperbolic secant. *)
Definition sech (x : R) : R := / cosh x.

(** f a + f (a + 1) + …, so many terms. *)
Fixpoint sum_terms (f : nat -> R) (a count : nat) : R :=
  match count with
  | O => 0
  | S c => sum_terms f a c + f (a + c)%nat
  end.

(** The sum of f over a, a + 1, …, b; 0 if b = a - 1. *)
Definition sum_over (a b : nat) (f : nat -> R) : R := sum_terms f a (b + 1 - a).

(** f a * f (a + 1) * …, so many factors. *)
Fixpoint product_terms (f : nat -> R) (a count : nat) : R :=
  match count with
  | O => 1
  | S c => product_terms f a c * f (a + c)%nat
  end.

(** The product of f over a, a + 1, …, b; 1 if b = a - 1. *)
Definition product_over (a b : nat) (f : nat -> R) : R := product_terms f a (b + 1 - a).

(** A matrix is the list of its rows. *)
Definition matrix : Type := list (list R).

(** Every entry times a number. *)
Definition mat_scale (c : R) (A : matrix) : matrix := map (map (fun x => c * x)) A.

(** Entry by entry. *)
Fixpoint row_add (a b : list R) : list R :=
  match a, b with
  | x :: a', y :: b' => x + y :: row_add a' b'
  | _, _ => nil
  end.

(** The sum of two matrices of one size. *)
Fixpoint mat_add (A B : matrix) : matrix :=
  match A, B with
  | a :: A', b :: B' => row_add a b :: mat_add A' B'
  | _, _ => nil
  end.

(** A row times a matrix: the sum of the matrix's rows, each times an entry. *)
Fixpoint row_times (a : list R) (B : matrix) : list R :=
  match a, B with
  | [x], [b] => map (fun y => x * y) b
  | x :: a', b :: B' => row_add (map (fun y => x * y) b) (row_times a' B')
  | _, _ => nil
  end.

(** The product of two matrices. *)
Definition mat_mul (A B : matrix) : matrix := map (fun a => row_times a B) A.

(** The determinant of a matrix of two rows and two columns. *)
Definition det2 (A : matrix) : R :=
  match A with
  | [[a; b]; [c; d]] => a * d - b * c
  | _ => 0
  end.
