(* ---------------------------------------------------------------------------------------------
   The least congruence on the darts of a log, and the log modulo it.              Sections IV, V

   Stated for any finite type with a successor `next`, a relation `linked` (the two ends of an edge
   that was crossed) and a predicate `marked` (the darts that must be one dart).

     congruence R         R is an equivalence kept by next and by crossing an edge, in which the
                          marked darts are all related.
     same                 the least congruence: x and y are the same if every congruence says so.
     glued p q            q is known to be the other end of the edge of p.
     settled p            the other end of p is known.
     folded               one dart for each class; folded_next, folded_end: its successor and, where
                          settled, its other end.
   --------------------------------------------------------------------------------------------- *)
From mathcomp Require Import all_ssreflect.
From Allworlds Require Import Model.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Section Gluing.
Variables (D : finType) (next : D -> D) (linked : rel D) (marked : pred D).
Implicit Types (x y z : D).

Record congruence (R : rel D) : Prop := Congruence {
  congruence_refl : forall x, R x x;
  congruence_sym : forall x y, R x y -> R y x;
  congruence_trans : forall y x z, R x y -> R y z -> R x z;
  congruence_next : forall x y, R x y -> R (next x) (next y);
  congruence_link : forall x y x' y', R x y -> linked x x' -> linked y y' -> R x' y';
  congruence_mark : forall x y, marked x -> marked y -> R x y }.

Definition is_congruence (R : rel D) :=
  [&& [forall x, R x x],
      [forall x, forall y, R x y ==> R y x],
      [forall y, forall x, forall z, R x y ==> R y z ==> R x z],
      [forall x, forall y, R x y ==> R (next x) (next y)],
      [forall x, forall y, forall x', forall y',
         R x y ==> linked x x' ==> linked y y' ==> R x' y'] &
      [forall x, forall y, marked x ==> marked y ==> R x y]].

Lemma congruenceP R : reflect (congruence R) (is_congruence R).
Proof.
apply: (iffP idP) => [|[H1 H2 H3 H4 H5 H6]].
  case/and5P=> /forallP H1 /forallP H2 /forallP H3 /forallP H4 /andP[/forallP H5 /forallP H6].
  split=> //.
  - by move=> x y; have /forallP/(_ y)/implyP := H2 x.
  - by move=> y x z; have /forallP/(_ x)/forallP/(_ z)/implyP H := H3 y => /H/implyP.
  - by move=> x y; have /forallP/(_ y)/implyP := H4 x.
  - move=> x y x' y'; have /forallP/(_ y)/forallP/(_ x')/forallP/(_ y')/implyP H := H5 x.
    by move=> /H/implyP{}H /H/implyP.
  by move=> x y; have /forallP/(_ y)/implyP H := H6 x => /H/implyP.
apply/and5P; split; [| | | |apply/andP; split]; apply/forallP=> x //.
- by apply/forallP=> y; apply/implyP; exact: H2.
- by do 2 apply/forallP=> ?; apply/implyP=> ?; apply/implyP; exact: H3.
- by apply/forallP=> y; apply/implyP; exact: H4.
- by do 3 apply/forallP=> ?; apply/implyP=> h1; apply/implyP=> h2; apply/implyP; exact: H5 h1 h2.
by apply/forallP=> ?; apply/implyP=> ?; apply/implyP; exact: H6.
Qed.

Definition same : rel D := fun x y =>
  [forall R : {set D * D}, is_congruence (fun u v => (u, v) \in R) ==> ((x, y) \in R)].

Lemma sameP x y :
  reflect (forall R : {set D * D}, congruence (fun u v => (u, v) \in R) -> (x, y) \in R) (same x y).
Proof.
apply: (iffP forallP) => H R; first by move/congruenceP; apply/implyP.
by apply/implyP=> /congruenceP; exact: H.
Qed.

Theorem same_least (R : rel D) x y : congruence R -> same x y -> R x y.
Proof.
case=> H1 H2 H3 H4 H5 H6 /sameP/(_ [set p | R p.1 p.2]); rewrite inE; apply.
split=> [u|u v|v u w|u v|u v u' v'|u v]; rewrite !inE //=;
  [exact: H2|exact: H3|exact: H4|exact: H5|].
exact: H6.
Qed.

Theorem same_congruence : congruence same.
Proof.
split.
- by move=> x; apply/sameP=> R [].
- by move=> x y /sameP H; apply/sameP=> R C; apply: (congruence_sym C); exact: H.
- move=> y x z /sameP H /sameP K; apply/sameP=> R C.
  by apply: (congruence_trans C) (H R C) (K R C).
- by move=> x y /sameP H; apply/sameP=> R C; apply: (congruence_next C); exact: H.
- move=> x y x' y' /sameP H l l'; apply/sameP=> R C.
  by apply: (congruence_link C) (H R C) l l'.
by move=> x y mx my; apply/sameP=> R C; exact: (congruence_mark C).
Qed.

Let refl := congruence_refl same_congruence.
Let sym := congruence_sym same_congruence.
Let trans := congruence_trans same_congruence.

Definition glued x y := [exists x', same x x' && linked x' y].
Definition settled x := [exists y, glued x y].

Lemma gluedP x y : reflect (exists2 x', same x x' & linked x' y) (glued x y).
Proof. by apply: (iffP existsP) => [[x' /andP[s l]]|[x' s l]]; exists x'; rewrite ?s. Qed.

Lemma glued_same x y u v : same x y -> glued x u -> glued y v -> same u v.
Proof.
move=> s /gluedP[x' sx lx] /gluedP[y' sy ly].
apply: (congruence_link same_congruence) lx ly; apply: trans (sym sx) _.
exact: trans s sy.
Qed.

(* ---- The folded log: darts that are the same are one ---- *)
Definition representative x := odflt x [pick y | same x y].

Lemma same_representative x : same x (representative x).
Proof. by rewrite /representative; case: pickP => //= _; exact: refl. Qed.

Lemma representative_eq x y : same x y -> representative x = representative y.
Proof.
move=> s; rewrite /representative (@eq_pick _ (same x) (same y)); last first.
  by move=> z; apply/idP/idP=> h; [exact: trans (sym s) h | exact: trans s h].
by case: pickP => // /(_ y); rewrite refl.
Qed.

Lemma representative_idem x : representative (representative x) == representative x.
Proof. by rewrite -(representative_eq (same_representative x)). Qed.

Definition folded := [finType of {x : D | representative x == x}].
Definition fold x : folded :=
  exist (fun y => representative y == y) (representative x) (representative_idem x).

Lemma foldE x y : (fold x == fold y) = same x y.
Proof.
apply/eqP/idP=> [/(congr1 val) /= E|s]; last by apply: val_inj; exact: representative_eq.
by apply: trans (same_representative x) _; rewrite E; apply: sym; exact: same_representative.
Qed.

Lemma fold_val (f : folded) : fold (val f) = f.
Proof. by apply: val_inj; case: f => x /= /eqP. Qed.

Definition folded_next (f : folded) := fold (next (val f)).
Definition folded_end (f : folded) := omap fold [pick y | glued (val f) y].

Lemma folded_nextE x : folded_next (fold x) = fold (next x).
Proof.
apply/eqP; rewrite foldE; apply: (congruence_next same_congruence).
by apply: sym; exact: same_representative.
Qed.

Lemma folded_iter k x : iter k folded_next (fold x) = fold (iter k next x).
Proof. by elim: k => //= k ->; rewrite folded_nextE. Qed.

Lemma folded_endP f g : reflect (exists x y, [/\ fold x = f, fold y = g & linked x y])
  (folded_end f == Some g).
Proof.
apply: (iffP eqP); rewrite /folded_end.
  case: pickP => //= y /gluedP[x s l] [E]; exists x, y; split=> //.
  by rewrite -(fold_val f); apply/eqP; rewrite foldE; exact: sym.
case=> x [y [E E' l]].
have s : same x (val f) by rewrite -foldE E fold_val.
have o : glued (val f) y by apply/gluedP; exists x => //; exact: sym.
case: pickP => [z oz|/(_ y)]; last by rewrite o.
by rewrite /= -E'; congr Some; apply/eqP; rewrite foldE; exact: glued_same (refl _) oz o.
Qed.

Lemma folded_end_none x : (folded_end (fold x) == None) = ~~ settled x.
Proof.
rewrite /folded_end; case: pickP => [y /gluedP[x' s l]|N] /=.
  suff -> : settled x by [].
  apply/existsP; exists y; apply/gluedP; exists x' => //.
  exact: trans (same_representative x) s.
suff -> : settled x = false by [].
apply/existsP=> -[y /gluedP[x' s l]]; have /negP[] := negbT (N y); apply/gluedP.
by exists x' => //; apply: trans s; apply: sym; exact: same_representative.
Qed.
End Gluing.

