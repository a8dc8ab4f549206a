(* ---------------------------------------------------------------------------------------------
   n-1 passes find a vertex, m-n+1 close a loop, in whatever order.                    Section VI

     counted v l C c      some run is in configuration c after v passes that found a vertex and l that
                          closed a loop, with C traversals in all.
     reached_counted      these are the runs of Pass.v.
     passes_of_each_kind  when U is empty, v = n-1 and l = m-n+1.
   --------------------------------------------------------------------------------------------- *)
From mathcomp Require Import all_ssreflect.
From Allworlds Require Import Model Maps PartialMaps Pass Correctness.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Section PassCounts.
Variable W : lighthouse_world.
Implicit Type c : configuration W.

Inductive counted : nat -> nat -> nat -> configuration W -> Prop :=
| CountedStart : counted 0 0 0 (initial W)
| CountedVertex v l C e c C1 c' : counted v l C c -> pass e c C1 c' ->
    size (degrees (mapped c')) = (size (degrees (mapped c))).+1 -> counted v.+1 l (C + C1) c'
| CountedLoop v l C e c C1 c' : counted v l C c -> pass e c C1 c' ->
    size (degrees (mapped c')) = size (degrees (mapped c)) -> counted v l.+1 (C + C1) c'.

Theorem reached_counted n C c : reached n C c <-> exists v l, counted v l C c /\ v + l = n.
Proof.
split=> [|[v [l [H <-]]]].
  elim=> [|m C0 e c1 C1 c2 _ [v [l [H <-]]] P]; first by exists 0, 0; split=> //; exact: CountedStart.
  have : size (degrees (mapped c2)) = (size (degrees (mapped c1))).+1 \/
         size (degrees (mapped c2)) = size (degrees (mapped c1)).
    by case: P => *; [right | left; rewrite /= size_rcons].
  case=> E; first by exists v.+1, l; split=> //; exact: (CountedVertex H P E).
  by exists v, l.+1; rewrite addnS; split=> //; exact: (CountedLoop H P E).
elim: H => [|v' l' C0 e c1 C1 c2 _ R P _|v' l' C0 e c1 C1 c2 _ R P _]; first exact: ReachedStart.
  exact: ReachedPass R P.
by rewrite addnS; exact: ReachedPass R P.
Qed.

Lemma counted_size v l C c : counted v l C c -> size (degrees (mapped c)) = v.+1.
Proof. by elim=> [|v' l' C0 e c1 C1 c2 _ IH _ ->|v' l' C0 e c1 C1 c2 _ IH _ ->] //; rewrite IH. Qed.

Theorem passes_of_each_kind v l C c : counted v l C c -> nothing_open c ->
  v.+1 = vertices W /\ l + vertices W = (edges W).+1.
Proof.
move=> H nopen; have R : reached (v + l) C c by apply/reached_counted; exists v, l.
have [r [I _ _]] := run_embedded R; have E : v.+1 = vertices W.
  rewrite -(counted_size H); apply/eqP; rewrite eqn_leq (size_vertices I) /=.
  exact: complete_vertices I (complete_when_nothing_open I nopen).
by split=> //; have [<- _ _] := run_correct R nopen; rewrite -E addnS addnC.
Qed.
End PassCounts.
