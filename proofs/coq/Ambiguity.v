(* ---------------------------------------------------------------------------------------------
   Darts that look alike, and when a world is ambiguous with position only.             Section III

   Two darts look alike if every list of motions gives equal percepts from both.  In one world the classes
   of this relation are what a robot can learn of where it is.  For any percept:
     indistinct x y       whatever the same turns and crossings lead to from x and from y is sensed alike;
                          indistinct_alikeP: so the two look alike.
     class x              the darts that look like x;  classes: all classes.
     lookalikes           how many darts look like the start: k.
     cone x               how many of the darts that look like x lie at its vertex.
     class_size           all classes have one size, k;  darts_by_classes: there are k times as many
                          darts as classes.
     cone_degree          cone divides the degree;  cone_size: and k, and there are k / cone vertices to a
                          class.
     crossed_class        a class that alpha maps to itself has an even size.
   With position (PositionTwins.v), where the start is marked:
     lookalikes_degree    k divides the degree of v0.
     unambiguous          every world that looks like this one is the same, place included.
     one_lookalike        k = 1: then it is so.  So it is where v0 has degree 1, and in trees.
     automorphic x y      an automorphism of the map takes x to y.
     places_of            the start may be taken for k darts; these are k / a places, a the number of
                          automorphisms that fix v0.
   --------------------------------------------------------------------------------------------- *)
From mathcomp Require Import all_ssreflect.
From Allworlds Require Import Model Maps Percepts RootedMaps Explorers Indistinguishable.
From Allworlds Require Import DoubleCover Trees PositionTwins.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(* ---- Darts that look alike, of one world or of two ---- *)
Section LookAlike.
Variables (G H : combinatorial_map) (P : eqType) (sG : G -> P) (sH : H -> P).
Implicit Types (x : G) (y : H).

Definition indistinct x y := [forall u, forall v, paired x y u v ==> (sG u == sH v)].

Lemma indistinct_alikeP d e x y :
  reflect (alike (M := rooted d) (N := rooted e) sG sH x y) (indistinct x y).
Proof.
have [WG WH] := (rooted_wellformed d, rooted_wellformed e).
apply: (iffP idP) => [/forallP I|L].
  apply: (@bisimulation_alike P (rooted d) (rooted e) sG sH (fun u v => paired x y u v)).
  - by move=> u v p; split=> //; have /forallP/(_ v)/implyP/(_ p)/eqP := I u.
  - by move=> u v; exact: paired_sigma.
  - by move=> u v; exact: paired_alpha.
  exact: paired_start.
apply/forallP=> u; apply/forallP=> v; apply/implyP=> /connectP[p].
elim: p x y L => [|[a b] p IH] x y L /=.
  by move=> _ [-> ->]; apply/eqP; exact: (alike_percept L).
case/andP=> S Sp; apply: (IH a b) => //; case/orP: S => /eqP[-> ->].
  exact: (alike_sigma WG WH L).
exact: (alike_alpha WG WH L).
Qed.

Lemma indistinct_senses x y : indistinct x y -> sG x = sH y.
Proof. by move/forallP/(_ x)/forallP/(_ y)/implyP/(_ (paired_start x y))/eqP. Qed.

Lemma indistinct_step x y x' y' : paired_step (x, y) (x', y') -> indistinct x y -> indistinct x' y'.
Proof.
move=> S /forallP I; apply/forallP=> u; apply/forallP=> v; apply/implyP=> p.
by have /forallP/(_ v)/implyP := I u; apply; exact: connect_trans (connect1 S) p.
Qed.

Lemma indistinct_sigma x y : indistinct x y -> indistinct (sigma x) (sigma y).
Proof. by apply: indistinct_step; rewrite /paired_step eqxx. Qed.

Lemma indistinct_alpha x y : indistinct x y -> indistinct (alpha x) (alpha y).
Proof. by apply: indistinct_step; rewrite /paired_step eqxx orbT. Qed.

Lemma indistinct_turn j x y : indistinct x y -> indistinct (iter j sigma x) (iter j sigma y).
Proof. by move=> I; elim: j => //= j; exact: indistinct_sigma. Qed.
End LookAlike.

(* ---- The classes of one world ---- *)
Section Classes.
Variables (G : combinatorial_map) (P : eqType) (senses : G -> P).
Implicit Types x y z d : G.
Local Notation indistinct := (indistinct senses senses).

Lemma indistinctP d x y : reflect
  (forall w, percepts_in (M := rooted d) senses w x = percepts_in (M := rooted d) senses w y)
  (indistinct x y).
Proof. by apply: (iffP (indistinct_alikeP _ _ d d _ _)) => [[]|]. Qed.

Lemma indistinct_refl : reflexive indistinct.
Proof. by move=> x; apply/(indistinctP x). Qed.

Lemma indistinct_sym : symmetric indistinct.
Proof. by move=> x y; apply/(indistinctP x)/(indistinctP x) => I w; rewrite I. Qed.

Lemma indistinct_trans : transitive indistinct.
Proof.
by move=> y x z /(indistinctP x) I /(indistinctP x) J; apply/(indistinctP x) => w; rewrite I J.
Qed.

(* turning back *)
Lemma indistinct_unturn j x y : indistinct (iter j sigma x) (iter j sigma y) -> indistinct x y.
Proof.
move=> H; have full z q : iter (q * degree z) sigma z = z.
  by elim: q => // q IH; rewrite mulSn iterD IH iter_degree.
have le : j <= degree y * j * degree x by rewrite mulnAC leq_pmull // muln_gt0 !degree_gt0.
have := indistinct_turn (degree y * j * degree x - j) H; rewrite -!iterD subnK // full.
by rewrite mulnC mulnCA mulnC full.
Qed.

Definition class x := [set y | indistinct x y].
Definition classes := [set class x | x in G].

Lemma mem_class x y : (y \in class x) = indistinct x y.
Proof. by rewrite inE. Qed.

Theorem class_size x y : #|class x| = #|class y|.
Proof.
rewrite !cardsE; exact: (@partners G G indistinct (@indistinct_sigma _ _ _ _ _)
  (@indistinct_alpha _ _ _ _ _)).
Qed.

Lemma class_partition : partition classes [set: G].
Proof.
have E : equivalence_rel indistinct.
  move=> x y z; split; first exact: indistinct_refl.
  move=> xy; apply/idP/idP; last exact: indistinct_trans.
  by apply: indistinct_trans; rewrite indistinct_sym.
have := equivalence_partitionP (R := indistinct) (D := [set: G]).
move=> /(_ (in3W E)); rewrite /equivalence_partition.
congr (partition _ _); apply/setP=> A; apply/imsetP/imsetP=> -[x _ ->]; exists x => //.
  by apply/setP=> y; rewrite !inE.
by apply/setP=> y; rewrite !inE.
Qed.

Theorem darts_by_classes d : #|G| = #|classes| * #|class d|.
Proof.
rewrite -cardsT; apply: card_uniform_partition class_partition => A /imsetP[x _ ->].
exact: class_size.
Qed.
(* ---- At one vertex ---- *)
Definition lookalikes_here x := [set y | at_same_vertex x y && indistinct x y].
Definition cone x := #|lookalikes_here x|.

Hypothesis degree_sensed : forall x y, senses x = senses y -> degree x = degree y.

Lemma cone_class x y : indistinct x y -> cone x = cone y.
Proof.
suff half u v : indistinct u v -> cone u <= cone v.
  by move=> H; apply/eqP; rewrite eqn_leq !half // indistinct_sym.
move=> H; pose f z := iter (findex sigma u z) sigma v.
have D := degree_sensed (indistinct_senses H).
rewrite /cone -(card_in_imset (f := f)) => [|z z']; last first.
  rewrite !inE => /andP[c _] /andP[c' _] E; rewrite -(iter_findex c) -(iter_findex c').
  have lt w : at_same_vertex u w -> findex sigma u w < degree v by rewrite -D; exact: findex_max.
  by rewrite -(findex_iter (lt z c)) -(findex_iter (lt z' c')) -/(f z) -/(f z') E.
apply/subset_leq_card/subsetP=> w /imsetP[z Kz ->{w}]; move: Kz; rewrite !inE => /andP[c uz].
rewrite /at_same_vertex fconnect_iter /=.
have vz := indistinct_turn (findex sigma u z) H; rewrite (iter_findex c) in vz.
by apply: indistinct_trans vz; apply: indistinct_trans uz; rewrite indistinct_sym.
Qed.

Lemma cone_vertex x y : at_same_vertex x y -> cone x = cone y.
Proof.
suff half u v : at_same_vertex u v -> cone u <= cone v.
  by move=> c; apply/eqP; rewrite eqn_leq !half // at_same_vertex_sym.
move/iter_findex <-; set i := findex _ _ _.
rewrite /cone -(card_imset _ (@iter_sigma_inj G i)).
apply/subset_leq_card/subsetP=> w /imsetP[z Kz ->{w}]; move: Kz.
rewrite !inE => /andP[c uz]; rewrite indistinct_turn // andbT.
rewrite at_same_vertex_sym; apply: connect_trans (fconnect_iter _ i u).
rewrite -/(at_same_vertex _ _) at_same_vertex_sym; apply: connect_trans c _; exact: fconnect_iter.
Qed.

Theorem cone_degree x : cone x %| degree x.
Proof.
pose V := [set y | at_same_vertex x y].
have E : {in V & &, equivalence_rel indistinct}.
  move=> u v w _ _ _; split; first exact: indistinct_refl.
  move=> uv; apply/idP/idP; last exact: indistinct_trans.
  by apply: indistinct_trans; rewrite indistinct_sym.
have H : #|V| = #|equivalence_partition indistinct V| * cone x.
  apply: card_uniform_partition (equivalence_partitionP E) => A /imsetP[y]; rewrite inE => c ->.
  rewrite (cone_vertex c); apply: eq_card => z; rewrite !inE; congr (_ && _).
  exact: (same_connect (fconnect_sym (@sigma_inj G)) c z).
have D : degree x = #|V| by rewrite cardsE.
by rewrite D H dvdn_mull.
Qed.

(* the vertices at which the darts of a class lie *)
Definition class_vertices x := equivalence_partition (@at_same_vertex G) (class x).

Theorem cone_size x : #|class x| = #|class_vertices x| * cone x.
Proof.
have E : {in class x & &, equivalence_rel (@at_same_vertex G)}.
  move=> u v w _ _ _; split; first exact: connect0.
  by move=> c; exact: (same_connect (fconnect_sym (@sigma_inj G)) c w).
apply: card_uniform_partition (equivalence_partitionP E) => A /imsetP[y]; rewrite inE => xy ->.
rewrite (cone_class xy); congr #|pred_of_set _|; apply/setP=> z; rewrite !inE andbC; congr (_ && _).
by apply/idP/idP; apply: indistinct_trans; rewrite // indistinct_sym.
Qed.

(* ---- An edge whose ends look alike ---- *)
Theorem crossed_class x : indistinct x (alpha x) -> ~~ odd #|class x|.
Proof.
move=> H; have two y : order alpha y = 2.
  apply: order_least; [exact: alpha_inj | by [] | by rewrite /= alphaK |].
  by case=> [|[|j]] // _; exact/eqP/alpha_neq.
rewrite -(fcard_order_set (n := 2) (@alpha_inj G)) ?muln2 ?odd_double //.
  by apply/subsetP=> y _; rewrite inE two.
apply: intro_closed; first exact: (fconnect_sym (@alpha_inj G)).
move=> y z /eqP <-; rewrite !inE => xy; apply: indistinct_trans H _; exact: indistinct_alpha.
Qed.
End Classes.

(* ---- Position: the start is marked ---- *)
Section Position.
Variables (G : combinatorial_map) (d : G).
Local Notation indistinct := (indistinct (position_of d) (position_of d)).
Local Notation class := (class (position_of d)).

Definition lookalikes := #|class d|.

Lemma position_degree (x y : G) : position_of d x = position_of d y -> degree x = degree y.
Proof. by case. Qed.

(* what looks like the start lies at v0 *)
Lemma lookalikes_at_v0 y : indistinct d y -> at_same_vertex d y.
Proof. by move/indistinct_senses => -[_ <-]; exact: connect0. Qed.

Lemma lookalikes_cone : lookalikes = cone (position_of d) d.
Proof.
apply: eq_card => y; rewrite !inE; case I: (indistinct d y); rewrite ?andbF // andbT.
exact/esym/lookalikes_at_v0.
Qed.

Theorem lookalikes_degree : lookalikes %| degree d.
Proof. by rewrite lookalikes_cone; exact: cone_degree. Qed.

(* ---- No other world looks like this one ---- *)
Definition unambiguous := forall (H : combinatorial_map) (e : H), look_alike d e ->
  isomorphic (rooted d) (rooted e).

Theorem one_lookalike : lookalikes = 1 -> unambiguous.
Proof.
move=> k1 H e A; pose R := paired d e.
have Rs := @paired_sigma G H d e; have Ra := @paired_alpha G H d e.
have twins x x' : R x e -> R x' e -> indistinct x x'.
  move=> /(paired_alike A)[_ _ E] /(paired_alike A)[_ _ E']; apply/(indistinctP (position_of d) d) => w.
  by rewrite E E'.
have one : partner_count d e = 1.
  apply/eqP; rewrite eqn_leq partner_count_gt0 andbT -(partners_back A e) -k1 /lookalikes.
  apply/subset_leq_card/subsetP=> x; rewrite !inE => Rx; apply: twins Rx; exact: paired_start.
have [f fP] : {f : G -> H | forall x, R x (f x)}.
  have ne x : exists y, R x y.
    by have /card_gt0P[y Ry] : 0 < #|[pred y | R x y]| by [rewrite (partners_of d e x) one]; exists y.
  by exists (fun x => xchoose (ne x)) => x; exact: (xchooseP (ne x)).
have [g gP] : {g : H -> G | forall y, R (g y) y}.
  have ne y : exists x, R x y.
    by have /card_gt0P[x Rx] : 0 < #|[pred x | R x y]| by [rewrite (partners_back A y) one]; exists x.
  by exists (fun y => xchoose (ne y)) => y; exact: (xchooseP (ne y)).
have fI x y : R x y -> y = f x.
  move=> Rx; have /card1P[z zE] : #|[pred y | R x y]| == 1 by rewrite (partners_of d e x) one.
  by have := zE y; have := zE (f x); rewrite !inE Rx fP => /esym/eqP-> /esym/eqP->.
have gI x y : R x y -> x = g y.
  move=> Rx; have /card1P[z zE] : #|[pred x | R x y]| == 1 by rewrite (partners_back A y) one.
  by have := zE x; have := zE (g y); rewrite !inE Rx gP => /esym/eqP-> /esym/eqP->.
exists f, g; split=> [x _|y _|] /=.
- split=> //; first by rewrite -(gI _ _ (fP x)).
    by rewrite -(fI _ _ (Rs _ _ (fP x))).
  by rewrite -(fI _ _ (Ra _ _ (fP x))).
- by split=> //; rewrite -(fI _ _ (gP y)).
by rewrite -(fI d e) //; exact: paired_start.
Qed.

Corollary one_door : degree d = 1 -> unambiguous.
Proof. by move=> D; apply: one_lookalike; have := lookalikes_degree; rewrite D dvdn1 => /eqP. Qed.
End Position.

(* trees are unambiguous even without position *)
Theorem tree_unambiguous (G : combinatorial_map) (d : G) : acyclic G -> unambiguous d.
Proof.
move=> tree H e A; apply: (proj1 (tree_iff_no_twin d) tree H e) => w.
have forget (K : combinatorial_map) (a x : K) v :
    percepts_in (M := rooted a) (@degree K) v x
    = map fst (percepts_in (M := rooted a) (position_of a) v x).
  by elim: v x => [|j v IH] x //=; rewrite IH.
by rewrite !forget A.
Qed.

(* ---- As many places as automorphisms leave ---- *)
Section Places.
Variables (G : combinatorial_map) (d : G).
Implicit Types x y z : G.

(* an automorphism of the map takes x to y *)
Definition automorphic x y := [exists f : {ffun G -> G},
  [&& [forall z, f (sigma z) == sigma (f z)], [forall z, f (alpha z) == alpha (f z)] & f x == y]].

Lemma automorphicP x y : reflect (exists f : G -> G,
  [/\ forall z, f (sigma z) = sigma (f z), forall z, f (alpha z) = alpha (f z) & f x = y])
  (automorphic x y).
Proof.
apply: (iffP existsP) => [[f /and3P[/forallP s /forallP a /eqP E]]|[f [s a E]]].
  by exists f; split=> // z; exact/eqP.
exists (finfun f); apply/and3P.
by split; [apply/forallP=> z | apply/forallP=> z |]; rewrite !ffunE ?s ?a ?E.
Qed.

(* what commutes with sigma and alpha is onto, and so a bijection *)
Lemma commuting_bijective (f : G -> G) : (forall z, f (sigma z) = sigma (f z)) ->
  (forall z, f (alpha z) = alpha (f z)) -> exists2 g : G -> G, cancel f g & cancel g f.
Proof.
move=> s a; have onto z : exists u, f u == z.
  apply: (@everywhere G (fun z => exists u, f u == z) (f d)) => [|u [v /eqP <-]|u [v /eqP <-]].
  - by exists d.
  - by exists (sigma v); rewrite s.
  by exists (alpha v); rewrite a.
pose g z := xchoose (onto z); have gK z : f (g z) = z by exact/eqP/(xchooseP (onto z)).
have gi : injective g by move=> u v /(congr1 f); rewrite !gK.
by exists g => // z; have /codomP[u ->] := injF_onto gi z; rewrite gK.
Qed.

Lemma automorphic_isomorphic x y : automorphic x y <-> isomorphic (rooted x) (rooted y).
Proof.
split=> [/automorphicP[f [s a E]]|[f [g [F _ r]]]]; last first.
  by apply/automorphicP; exists f; split=> // z; have [] := F z isT.
have [g fK gK] := commuting_bijective s a.
by exists f, g; split=> [z _|z _|] //=; split.
Qed.

Lemma automorphic_refl x : automorphic x x.
Proof. by apply/automorphicP; exists id. Qed.

Lemma automorphic_sym x y : automorphic x y -> automorphic y x.
Proof. by rewrite !automorphic_isomorphic => I; exact: isomorphic_sym (rooted_wellformed x) I. Qed.

Lemma automorphic_trans x y z : automorphic x y -> automorphic y z -> automorphic x z.
Proof. by rewrite !automorphic_isomorphic; exact: isomorphic_trans. Qed.

(* what turns with the darts and keeps v0 keeps what is sensed *)
Lemma position_kept (f : G -> G) x : injective f -> (forall z, f (sigma z) = sigma (f z)) ->
  at_same_vertex d x -> at_same_vertex d (f x) -> forall z, position_of d (f z) = position_of d z.
Proof.
move=> fi s c c' z; have turn j u : f (iter j sigma u) = iter j sigma (f u) by elim: j => //= j <-.
rewrite /position_of; congr (_, _).
  apply: order_least; [exact: sigma_inj | exact: degree_gt0 | by rewrite -turn iter_degree |].
  move=> j /andP[j0 lj]; rewrite -turn => /fi E.
  by have := findex_iter lj; rewrite E findex0 => e0; rewrite -e0 in j0.
have same p q : at_same_vertex d p -> at_same_vertex d q = at_same_vertex p q.
  by move=> cp; rewrite /at_same_vertex (same_connect (fconnect_sym sigma_inj) cp).
rewrite (same _ _ c') (same _ _ c); apply/idP/idP=> /iter_findex.
  by rewrite -turn => /fi <-; exact: fconnect_iter.
by move=> <-; rewrite turn; exact: fconnect_iter.
Qed.

(* an automorphism that keeps v0 takes each dart to one that looks like it *)
Lemma automorphism_looks_alike (f : G -> G) x :
  (forall z, f (sigma z) = sigma (f z)) -> (forall z, f (alpha z) = alpha (f z)) ->
  at_same_vertex d x -> at_same_vertex d (f x) ->
  forall z, indistinct (position_of d) (position_of d) z (f z).
Proof.
move=> s a c c' z; have [g fK _] := commuting_bijective s a.
apply/(indistinct_alikeP _ _ d d).
apply: (@bisimulation_alike _ (rooted d) (rooted d) _ _ (fun u v => f u = v)) => //
  [u _ <-|u _ <-|u _ <-]; [|exact: s|exact: a].
by split=> //; rewrite (position_kept (can_inj fK) s c c').
Qed.

(* the automorphisms that keep v0, by where they take the start *)
Definition automorphisms := #|[set y | at_same_vertex d y && automorphic d y]|.
(* the places in the map for which the start may be taken *)
Definition places := equivalence_partition automorphic (class (position_of d) d).

Theorem places_of : lookalikes d = #|places| * automorphisms.
Proof.
have E : {in class (position_of d) d & &, equivalence_rel automorphic}.
  move=> x y z _ _ _; split; first exact: automorphic_refl.
  move=> xy; apply/idP/idP; last exact: automorphic_trans.
  by apply: automorphic_trans; exact: automorphic_sym.
pose reach x := [set z in class (position_of d) d | automorphic x z].
have at0 y : y \in class (position_of d) d -> at_same_vertex d y.
  by rewrite inE; exact: lookalikes_at_v0.
have le x x' : x \in class (position_of d) d -> x' \in class (position_of d) d ->
    #|reach x| <= #|reach x'|.
  move=> kx kx'; pose to z : {ffun G -> G} := odflt [ffun u => u] [pick f : {ffun G -> G} |
    [&& [forall u, f (sigma u) == sigma (f u)], [forall u, f (alpha u) == alpha (f u)] & f x == z]].
  have toP z : automorphic x z -> [/\ forall u, to z (sigma u) = sigma (to z u),
      forall u, to z (alpha u) = alpha (to z u) & to z x = z].
    case/existsP=> f H; rewrite /to; case: pickP => [f' /and3P[/forallP s /forallP a /eqP e]|/(_ f)].
      by split=> // u; exact/eqP.
    by rewrite H.
  rewrite -(card_in_imset (f := fun z => to z x')) => [|z z']; last first.
    rewrite !inE => /andP[_ /toP[s a e]] /andP[_ /toP[s' a' e']] E'.
    by rewrite -e -e'; apply: (@morphisms_agree G G sigma alpha _ _ x').
  apply/subset_leq_card/subsetP=> u /imsetP[z Kz ->{u}]; move: Kz; rewrite inE => /andP[kz /toP[s a e]].
  rewrite inE; apply/andP; split; last by apply/automorphicP; exists (to z).
  rewrite inE; rewrite inE in kx'; apply: indistinct_trans kx' _.
  by apply: (automorphism_looks_alike (x := x)); rewrite ?e ?at0.
have size A : A \in places -> #|A| = #|reach d|.
  have kd : d \in class (position_of d) d by rewrite inE; exact: indistinct_refl.
  by case/imsetP=> y ky ->; apply/eqP; rewrite eqn_leq !le.
rewrite /lookalikes (card_uniform_partition size (equivalence_partitionP E)); congr (_ * _).
apply: eq_card => z; rewrite !inE.
case: (boolP (automorphic d z)) => [/automorphicP[f [s a e]]|]; rewrite ?andbF // !andbT.
apply/idP/idP=> [|c]; first exact: lookalikes_at_v0.
by rewrite -e; apply: (automorphism_looks_alike s a (connect0 _ d)); rewrite e.
Qed.
End Places.
