(* ---------------------------------------------------------------------------------------------
   Policies: which dart leaves U.                                              Algorithm 1, line 3

     fifo       the dart that came into S first.
     lifo       the dart that came into S last.
     nearest    the dart with the shortest path to it, the first among equals.
   All of them take breadth-first paths, and hypotheses in the order of U.  The theorems of
   Refinement.v hold of every policy, so of these; they are stated here once more for each.
   --------------------------------------------------------------------------------------------- *)
From mathcomp Require Import all_ssreflect.
From Allworlds Require Import Model Percepts RootedMaps Explorers PartialMaps Routes Algorithm.
From Allworlds Require Import Refinement.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(* an empty path leads nowhere new: where it is no path, a breadth-first one is taken *)
Definition any_path (k : knowledge) (e : dart) : seq nat := [::].
Definition same_order (k : knowledge) (e : dart) (H : seq dart) := H.

Definition fifo := Policy (fun k => head (0, 0) (unexplored k)) any_path same_order any_path.
Definition lifo := Policy (fun k => last (0, 0) (unexplored k)) any_path same_order any_path.

Definition distance k (e : dart) := size (route (known_map k) (at_dart k) e.1).1.
Fixpoint closest k e (U : seq dart) :=
  if U is f :: U' then closest k (if distance k f < distance k e then f else e) U' else e.
Definition nearest :=
  Policy (fun k => closest k (head (0, 0) (unexplored k)) (unexplored k)) any_path same_order any_path.

Section Right.
Variable W : lighthouse_world.
Local Notation is_right pol := (right denote (algorithm1 pol) (rooted (@start W)) (@percept_of W)).

Corollary fifo_right : is_right fifo. Proof. exact: algorithm1_right. Qed.

Corollary lifo_right : is_right lifo. Proof. exact: algorithm1_right. Qed.

Corollary nearest_right : is_right nearest. Proof. exact: algorithm1_right. Qed.
End Right.
