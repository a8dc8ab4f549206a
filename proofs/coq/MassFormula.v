(* ---------------------------------------------------------------------------------------------
   The mass formula: how many regluings and turnings a world has.                       Section III

   Position only.  map_known_iff (RegluingCount.v) compares the number of regluings with that of places times
   turnings.  Both are counted here: dart by dart, each choice leaves a smaller task of the same kind, and
   how many choices there are depends on how many darts of each class are left.

     pairings n           n-1 times n-3 times ...: the ways to put n things together by twos; 0 if n is odd.
     edge_classes         what lies over the edges of the quotient: each class with that of the other ends.
     over_semi_edge B     B is one class: it lies over a semi-edge.
     ordinary_edges, semi_edges   how many there are of the two kinds.
     gluings U            the regluings of the darts of U alone.
     gluings_by_partner   any one of them first.
     regluings_counted    k! for each ordinary edge of the quotient, pairings k for each semi-edge.

     vertex_classes       what lies over the vertices of the quotient.
     cone_of B, sheets_of B   the cone index there, b, and how many vertices lie over it: k / b.
     turnings_of U V      the turnings of whole vertices, those of U, to those of V.
     turns_by_image       any one of them first.
     turnings_counted     b^(k/b) (k/b)! for each vertex of the quotient other than v0.
   --------------------------------------------------------------------------------------------- *)
From mathcomp Require Import all_ssreflect.
From Allworlds Require Import Model Maps PositionTwins Ambiguity RegluingCount.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Fixpoint pairings n := if n is m.+1 then (if m is l.+1 then m * pairings l else 0) else 1.

Section Gluings.
Variables (G : combinatorial_map) (d : G).
Local Notation indistinct := (indistinct (position_of d) (position_of d)).
Local Notation class := (class (position_of d)).
Local Notation dart_function := {ffun G -> G}.
Implicit Types (b c : dart_function) (x y z : G) (U B : {set G}).

Local Notation refl := (@indistinct_refl G _ (position_of d)).
Local Notation sym := (@indistinct_sym G _ (position_of d)).
Local Notation trans := (@indistinct_trans G _ (position_of d)).

Lemma indistinct_ends x y : indistinct (alpha x) (alpha y) = indistinct x y.
Proof. by apply/idP/idP=> /indistinct_alpha; rewrite ?alphaK. Qed.

Lemma indistinct_end x y : indistinct (alpha x) y = indistinct x (alpha y).
Proof. by rewrite -indistinct_ends alphaK. Qed.

Lemma indistinct_left x y z : indistinct x y -> indistinct x z = indistinct y z.
Proof.
by move=> xy; apply/idP/idP; [apply: trans; rewrite sym | exact: trans xy].
Qed.

Definition edge_class x := [set y | indistinct x y || indistinct (alpha x) y].
Definition edge_classes := [set edge_class x | x in G].
Definition over_semi_edge B := [exists x in B, indistinct x (alpha x)].

Lemma edge_class_same x y : y \in edge_class x -> edge_class y = edge_class x.
Proof.
rewrite inE => /orP[xy|xy]; apply/setP=> z; rewrite !inE.
  by rewrite -(indistinct_left z xy) -(indistinct_left z (indistinct_alpha xy)).
rewrite -(indistinct_left z xy) orbC; congr (_ || _).
by apply/esym/indistinct_left; rewrite -indistinct_end.
Qed.

Lemma edge_class_self x : x \in edge_class x.
Proof. by rewrite inE refl. Qed.

Lemma over_semi_edge_at x : over_semi_edge (edge_class x) = indistinct x (alpha x).
Proof.
apply/existsP/idP=> [[y /andP[]]|c]; last by exists x; rewrite edge_class_self.
rewrite inE => /orP[xy|xy].
  by rewrite -(indistinct_left _ xy) sym -(indistinct_left _ (indistinct_alpha xy)) sym.
have xy' : indistinct x (alpha y) by rewrite -indistinct_end.
by rewrite sym => H; apply: trans xy' _; apply: trans H _; rewrite sym.
Qed.

(* ---- One gluing after the other ---- *)
Definition gluing U b := [&& [forall x, b (b x) == x], [forall x, (b x == x) == (x \notin U)]
  & [forall x in U, indistinct (alpha x) (b x)]].
Definition gluings U := [set b | gluing U b].

Lemma gluingP U b : reflect [/\ involutive b, forall x, (b x == x) = (x \notin U)
  & forall x, x \in U -> indistinct (alpha x) (b x)] (gluing U b).
Proof.
apply: (iffP and3P) => [[/forallP K /forallP N /forall_inP A]|[K N A]].
  by split=> // x; [exact/eqP/K | have /eqP := N x].
by split; [apply/forallP=> x; rewrite K | apply/forallP=> x; rewrite N | exact/forall_inP].
Qed.

Lemma gluings_all : gluings setT = regluings d.
Proof.
apply/setP=> b; rewrite !inE; apply/gluingP/regluingP=> -[K N A]; split=> // x.
- by rewrite N inE.
- exact: A.
by rewrite inE; apply/negbTE.
Qed.

Definition new_ends U x := [set y in U | indistinct (alpha x) y && (y != x)].

Lemma gluings_of_pair U x y : x \in U -> y \in new_ends U x ->
  #|[set b in gluings U | b x == y]| = #|gluings (U :\: [set x; y])|.
Proof.
move=> xU; rewrite inE => /andP[second_in /andP[second_near second_other]].
pose join c : dart_function := [ffun z => if z == x then y else if z == y then x else c z].
have out c z : gluing (U :\: [set x; y]) c -> z \in [set x; y] -> c z = z.
  by case/gluingP=> _ N _ m; apply/eqP; rewrite N !inE; rewrite !inE in m; rewrite m.
have inj : {in gluings (U :\: [set x; y]) &, injective join}.
  move=> c c'; rewrite !inE => g g' /ffunP E; apply/ffunP=> z; have := E z; rewrite !ffunE.
  have [->|zx] := eqVneq z x; first by rewrite !out ?inE ?eqxx.
  by have [->|zy] := eqVneq z y; first by rewrite !out ?inE ?eqxx ?orbT.
rewrite -(card_in_imset inj); apply: eq_card => b; rewrite !inE.
apply/andP/imsetP=> [[/gluingP[K N A] /eqP bx]|[c]].
  have bz : b y = x by rewrite -bx K.
  exists [ffun z => if (z == x) || (z == y) then z else b z]; last first.
    apply/ffunP=> z; rewrite !ffunE; have [->|zx] := eqVneq z x; first by rewrite bx.
    by have [->|zy] := eqVneq z y.
  rewrite inE; apply/gluingP; split=> z; rewrite ?ffunE.
  - have bij : (b z == x) || (b z == y) = (z == y) || (z == x).
      by congr (_ || _); [rewrite -{1}bz | rewrite -{1}bx]; rewrite (inj_eq (inv_inj K)).
    have [->|zx] /= := eqVneq z x; first by rewrite eqxx.
    have [->|zy] /= := eqVneq z y; first by rewrite eqxx orbT.
    by rewrite bij (negbTE zx) (negbTE zy) K.
  - rewrite !inE; have [->|zx] /= := eqVneq z x; first by rewrite eqxx.
    by have [->|zy] /= := eqVneq z y; [rewrite eqxx | rewrite N].
  by rewrite !inE => /andP[/norP[/negbTE zx /negbTE zy] zU]; rewrite zx zy; exact: A.
rewrite inE => /[dup] g /gluingP[K N A] ->; split; last by rewrite ffunE eqxx.
apply/gluingP; split=> z; rewrite ?ffunE.
- have cx : c x = x by apply: out g _; rewrite !inE eqxx.
  have cy : c y = y by apply: out g _; rewrite !inE eqxx orbT.
  have [->|zx] := eqVneq z x; first by rewrite (negbTE second_other) eqxx.
  have [->|zy] := eqVneq z y; first by rewrite eqxx.
  have -> : (c z == x) = false by rewrite -[X in _ == X]cx (inj_eq (inv_inj K)) (negbTE zx).
  by have -> : (c z == y) = false by rewrite -[X in _ == X]cy (inj_eq (inv_inj K)) (negbTE zy).
- have [->|zx] := eqVneq z x; first by rewrite (negbTE second_other) xU.
  have [->|zy] := eqVneq z y; first by rewrite eq_sym (negbTE second_other) second_in.
  by rewrite N !inE (negbTE zx) (negbTE zy).
have [->|zx] := eqVneq z x; first by [].
have [->|zy] := eqVneq z y; first by rewrite indistinct_end sym.
by move=> zU; apply: A; rewrite !inE (negbTE zx) (negbTE zy).
Qed.

Lemma gluings_by_partner U x : x \in U ->
  #|gluings U| = \sum_(y in new_ends U x) #|gluings (U :\: [set x; y])|.
Proof.
move=> xU; rewrite -sum1_card (partition_big (fun b => b x) (mem (new_ends U x))) /= => [|b].
  by apply: eq_bigr => y yP; rewrite -(gluings_of_pair xU yP) -sum1_card; apply: eq_bigl => b; rewrite !inE.
rewrite inE => /gluingP[K N A]; rewrite !inE A // N xU /= andbT.
by move: (N (b x)); rewrite K eq_sym N xU => /esym/negbFE.
Qed.

(* ---- How many ---- *)
Definition balanced U := forall z, #|U :&: class z| = #|U :&: class (alpha z)|.
Definition gluing_weight B U := if over_semi_edge B then pairings #|U :&: B| else (#|U :&: B|./2)`!.

Lemma gluings_none : #|gluings set0| = 1.
Proof.
rewrite (_ : gluings set0 = [set [ffun z => z]]) ?cards1 //; apply/setP=> b; rewrite !inE.
apply/gluingP/eqP=> [[_ N _]|->]; first by apply/ffunP=> z; rewrite ffunE; apply/eqP; rewrite N inE.
by split=> z; rewrite ?inE // ?ffunE ?eqxx.
Qed.

Lemma noncrossed_disjoint x : ~~ indistinct x (alpha x) -> forall U,
  #|U :&: edge_class x| = #|U :&: class x| + #|U :&: class (alpha x)|.
Proof.
move=> nc U; rewrite -cardsUI (_ : (U :&: class x) :&: (U :&: class (alpha x)) = set0) ?cards0 ?addn0.
  by apply: eq_card => z; rewrite !inE; case: (z \in U).
apply/setP=> z; rewrite !inE; apply/negP=> /andP[/andP[_ xz] /andP[_ az]]; case/negP: nc.
by rewrite (indistinct_left _ xz) sym.
Qed.

Lemma balanced_half U x : balanced U -> ~~ indistinct x (alpha x) ->
  #|U :&: edge_class x| = (#|U :&: class (alpha x)|).*2.
Proof. by move=> bal nc; rewrite noncrossed_disjoint // bal addnn. Qed.

Lemma new_ends_counted U x : balanced U -> x \in U -> #|new_ends U x| =
  if over_semi_edge (edge_class x) then #|U :&: edge_class x|.-1 else #|U :&: edge_class x|./2.
Proof.
move=> bal xU; rewrite over_semi_edge_at; have [c|nc] := boolP (indistinct x (alpha x)).
  rewrite (cardsD1 x (U :&: _)) inE xU edge_class_self /=; apply: eq_card => y; rewrite !inE.
  by rewrite (indistinct_left _ c) orbb; case: (y \in U); rewrite ?andbF //= andbC.
rewrite balanced_half // doubleK; apply: eq_card => y; rewrite !inE.
case: (y \in U) => //=; have [->|] := eqVneq y x; last by rewrite andbT.
by rewrite andbF sym (negbTE nc).
Qed.

(* ---- What is left after one gluing ---- *)
Section Pair.
Variables (U : {set G}) (x y : G).
Hypotheses (xU : x \in U) (yP : y \in new_ends U x).
Local Notation V := (U :\: [set x; y]).

Let second_in : y \in U. Proof. by move: yP; rewrite inE => /andP[]. Qed.
Let second_near : indistinct (alpha x) y. Proof. by move: yP; rewrite inE => /and3P[]. Qed.
Let second_other : y != x. Proof. by move: yP; rewrite inE => /and3P[]. Qed.

Lemma left_in A : #|U :&: A| = (x \in A) + (y \in A) + #|V :&: A|.
Proof.
rewrite (cardsD1 x) (cardsD1 y ((U :&: A) :\ x)) !inE xU second_in second_other /= addnA; congr (_ + _).
by apply: eq_card => z; rewrite !inE; case: (z == x); case: (z == y); rewrite //= andbF.
Qed.

Lemma left_balanced : balanced U -> balanced V.
Proof.
move=> bal z; have := bal z; rewrite !left_in !inE.
have -> : indistinct (alpha z) x = indistinct z y.
  by rewrite indistinct_end sym (indistinct_left _ second_near) sym.
have -> : indistinct (alpha z) y = indistinct z x.
  by rewrite sym -(indistinct_left _ second_near) indistinct_ends sym.
move=> E; apply: (@addnI (indistinct z x + indistinct z y)); rewrite E.
by rewrite (addnC (indistinct z x : nat)).
Qed.

Lemma left_here : #|U :&: edge_class x| = #|V :&: edge_class x|.+2.
Proof. by rewrite left_in edge_class_self inE second_near orbT. Qed.

Lemma left_elsewhere B : B \in edge_classes -> B != edge_class x -> #|V :&: B| = #|U :&: B|.
Proof.
case/imsetP=> z _ -> ne; rewrite left_in.
have out t : t \in edge_class x -> t \in edge_class z = false.
  by move=> tx; apply: contraNF ne => tz; rewrite -(edge_class_same tz) (edge_class_same tx).
by rewrite !out ?edge_class_self // inE second_near orbT.
Qed.
End Pair.

Theorem gluings_counted U : balanced U -> #|gluings U| = \prod_(B in edge_classes) gluing_weight B U.
Proof.
have [n] := ubnP #|U|; elim: n U => // n IH U lt bal.
have [->|[x xU]] := set_0Vmem U.
  by rewrite gluings_none big1 // => B _; rewrite /gluing_weight set0I cards0; case: ifP.
have Bx : edge_class x \in edge_classes by apply: imset_f.
pose rest := \prod_(B in edge_classes | B != edge_class x) gluing_weight B U.
rewrite (gluings_by_partner xU) (bigD1 _ Bx) /= -/rest.
pose u := #|U :&: edge_class x|.
pose w := if over_semi_edge (edge_class x) then pairings (u - 2) else ((u - 2)./2)`!.
rewrite (eq_bigr (fun _ => w * rest)) => [|y yP]; last first.
  have lt' : #|U :\: [set x; y]| < n.
    apply: leq_trans (lt : #|U| <= n); apply/proper_card/properP; split; first exact: subsetDl.
    by exists x; rewrite ?inE ?eqxx.
  rewrite (IH _ lt' (left_balanced xU yP bal)) (bigD1 _ Bx) /=.
  rewrite /w /gluing_weight /u (left_here xU yP) subn2 /=.
  by congr (_ * _); apply: eq_bigr => B /andP[BE ne]; rewrite /gluing_weight (left_elsewhere xU yP BE ne).
rewrite sum_nat_const new_ends_counted // mulnA; congr (_ * _); rewrite /w /gluing_weight -/u {w}.
have u_gt0 : 0 < u by apply/card_gt0P; exists x; rewrite inE xU edge_class_self.
case C: (over_semi_edge _).
  by case: u u_gt0 => // -[|l] _; rewrite ?mul0n // subn2.
move: C; rewrite over_semi_edge_at => /negbT nc; move: u_gt0; rewrite /u balanced_half // doubleK.
by case: #|_| => // h _; rewrite doubleS subn2 /= doubleK factS.
Qed.
(* the ordinary edges of the quotient, and its semi-edges *)
Definition ordinary_edges := #|[set B in edge_classes | ~~ over_semi_edge B]|.
Definition semi_edges := #|[set B in edge_classes | over_semi_edge B]|.

Theorem regluings_counted :
  #|regluings d| = (lookalikes d)`! ^ ordinary_edges * pairings (lookalikes d) ^ semi_edges.
Proof.
have bal : balanced setT by move=> z; rewrite !setTI; exact: class_size.
rewrite -gluings_all gluings_counted // (bigID over_semi_edge) /= mulnC.
congr (_ * _); rewrite -prod_nat_const.
  apply: eq_big => [B|B /andP[/imsetP[x _ ->] nc]]; first by rewrite inE.
  rewrite /gluing_weight (negbTE nc); move: nc; rewrite over_semi_edge_at => nc.
  by rewrite balanced_half // doubleK setTI (class_size _ (alpha x) d).
apply: eq_big => [B|B /andP[/imsetP[x _ ->] c]]; first by rewrite inE.
rewrite /gluing_weight c setTI; move: c; rewrite over_semi_edge_at => c; congr pairings.
rewrite /lookalikes (class_size _ d x); apply: eq_card => z; rewrite !inE.
by rewrite -(indistinct_left _ c) orbb.
Qed.
End Gluings.

Section Turnings.
Variables (G : combinatorial_map) (d : G).
Local Notation indistinct := (indistinct (position_of d) (position_of d)).
Local Notation class := (class (position_of d)).
Local Notation cone := (cone (position_of d)).
Local Notation dart_function := {ffun G -> G}.
Implicit Types (f c : dart_function) (x y z t : G) (U V B : {set G}).

Local Notation refl := (@indistinct_refl G _ (position_of d)).
Local Notation sym := (@indistinct_sym G _ (position_of d)).
Local Notation trans := (@indistinct_trans G _ (position_of d)).
Local Notation vsym := (fconnect_sym (@sigma_inj G)).

Definition darts_round x := [set z | at_same_vertex x z].
Definition whole_vertices U := forall z, (sigma z \in U) = (z \in U).

Lemma whole_turn U i z : whole_vertices U -> (iter i sigma z \in U) = (z \in U).
Proof. by move=> cU; elim: i => //= i <-; rewrite cU. Qed.

Lemma whole_vertex U x z : whole_vertices U -> at_same_vertex x z -> (z \in U) = (x \in U).
Proof. by move=> cU /iter_findex <-; exact: whole_turn. Qed.

Lemma vertex_next x z : at_same_vertex x (sigma z) = at_same_vertex x z.
Proof. by rewrite /at_same_vertex -(same_connect_r vsym (fconnect1 sigma z)). Qed.

Lemma whole_left U x : whole_vertices U -> whole_vertices (U :\: darts_round x).
Proof. by move=> cU z; rewrite !inE cU vertex_next. Qed.

Lemma indistinct_degree x y : indistinct x y -> degree x = degree y.
Proof. by move/indistinct_senses => -[]. Qed.

(* ---- Turnings of the darts of U, to darts of V ---- *)
Definition turns_into U V f := [&& [forall z, (z \notin U) ==> (f z == z)],
  [forall z in U, [&& f z \in V, f (sigma z) == sigma (f z) & indistinct z (f z)]]
  & [forall z in U, [forall t in U, (f z == f t) ==> (z == t)]]].
Definition turnings_of U V := [set f | turns_into U V f].

Lemma turnsP U V f : reflect [/\ forall z, z \notin U -> f z = z,
  forall z, z \in U -> [/\ f z \in V, f (sigma z) = sigma (f z) & indistinct z (f z)]
  & {in U &, injective f}] (turns_into U V f).
Proof.
apply: (iffP and3P) => [[/forallP O /forall_inP I /forall_inP J]|[O I J]]; split.
- by move=> z zU; apply/eqP; exact: (implyP (O z)).
- by move=> z /I/and3P[? /eqP ? ?].
- by move=> z t zU tU E; apply/eqP; have /forall_inP/(_ t tU)/implyP := J z zU; apply; rewrite E.
- by apply/forallP=> z; apply/implyP=> /O ->.
- by apply/forall_inP=> z /I[? -> ?]; apply/and3P.
by apply/forall_inP=> z zU; apply/forall_inP=> t tU; apply/implyP=> /eqP E; apply/eqP; exact: J.
Qed.

Lemma turns_turn U V f i z : whole_vertices U -> turns_into U V f -> z \in U ->
  f (iter i sigma z) = iter i sigma (f z).
Proof.
move=> cU /turnsP[_ I _] zU; elim: i => //= i <-.
by have [] := I (iter i sigma z); rewrite ?whole_turn.
Qed.

Section Vertex.
Variables (U V : {set G}) (x y : G).
Hypotheses (cU : whole_vertices U) (cV : whole_vertices V).
Hypotheses (xU : x \in U) (yV : y \in V) (xy : indistinct x y).

Let turned_along z := iter (findex sigma x z) sigma y.

Lemma turned_next z : at_same_vertex x z -> turned_along (sigma z) = sigma (turned_along z).
Proof.
move=> c; rewrite /turned_along; set i := findex _ _ z.
have -> : sigma z = iter (i.+1 %% degree x) sigma x by rewrite turn_modulo_degree /= iter_findex.
by rewrite findex_iter ?ltn_pmod ?degree_gt0 // (indistinct_degree xy) turn_modulo_degree.
Qed.

Lemma turned_inj z t : at_same_vertex x z -> at_same_vertex x t -> turned_along z = turned_along t -> z = t.
Proof.
move=> cz ct E; rewrite -(iter_findex cz) -(iter_findex ct).
have lt w : at_same_vertex x w -> findex sigma x w < order sigma y.
  by move=> c; rewrite -/(degree y) -(indistinct_degree xy); exact: findex_max.
by rewrite -(findex_iter (lt _ cz)) -(findex_iter (lt _ ct)) -/(turned_along z) -/(turned_along t) E.
Qed.

Lemma turns_from :
  #|[set f in turnings_of U V | f x == y]| = #|turnings_of (U :\: darts_round x) (V :\: darts_round y)|.
Proof.
pose join c : dart_function := [ffun z => if at_same_vertex x z then turned_along z else c z].
have out c z : turns_into (U :\: darts_round x) (V :\: darts_round y) c -> at_same_vertex x z -> c z = z.
  by case/turnsP=> O _ _ m; apply: O; rewrite !inE m.
have inj : {in turnings_of (U :\: darts_round x) (V :\: darts_round y) &, injective join}.
  move=> c c'; rewrite !inE => g g' /ffunP E; apply/ffunP=> z; have := E z; rewrite !ffunE.
  by case: ifP => // m _; rewrite !out.
rewrite -(card_in_imset inj); apply: eq_card => f; rewrite !inE; apply/andP/imsetP=> [[g /eqP fx]|[c]].
  have /turnsP[O I J] := g.
  have at_x z : at_same_vertex x z -> f z = turned_along z.
    by move=> c; rewrite -{1}(iter_findex c) (turns_turn _ cU g xU) fx.
  exists [ffun z => if at_same_vertex x z then z else f z]; last first.
    by apply/ffunP=> z; rewrite !ffunE; have [/at_x|] := boolP (at_same_vertex x z).
  rewrite inE; apply/turnsP; split=> [z|z|z t].
  - by rewrite !inE ffunE negb_and negbK => /orP[->|/O ->] //; case: ifP.
  - rewrite !inE => /andP[nx zU]; have [fV fs fn] := I z zU; rewrite !ffunE vertex_next (negbTE nx).
    split=> //; rewrite fV andbT; apply: contra nx => c.
    have E : f (iter (findex sigma y (f z)) sigma x) = f z.
      by rewrite (turns_turn _ cU g xU) fx iter_findex.
    by rewrite -(J _ _ _ zU E) ?whole_turn //; exact: fconnect_iter.
  rewrite !inE !ffunE => /andP[nx zU] /andP[nx' tU]; rewrite (negbTE nx) (negbTE nx'); exact: J.
rewrite inE => /[dup] g /turnsP[O I J] ->; split; last first.
  by rewrite ffunE /at_same_vertex connect0 /turned_along findex0.
have vx z : at_same_vertex x z -> z \in U by move=> cz; rewrite (whole_vertex cU cz).
apply/turnsP; split=> [z zU|z zU|z t zU tU]; rewrite !ffunE.
- case: ifP => [/vx|nx]; first by rewrite (negbTE zU).
  by apply: O; rewrite !inE (negbTE zU) andbF.
- rewrite vertex_next; case: ifP => [cz|/negbT nx].
    split; [by rewrite whole_turn | exact: turned_next |].
    by rewrite -{1}(iter_findex cz); exact: indistinct_turn.
  have [|fV fs fn] := I z; first by rewrite !inE nx.
  by split=> //; move: fV; rewrite !inE => /andP[].
have at_y w : at_same_vertex y (turned_along w) by exact: fconnect_iter.
have off w : w \in U -> ~~ at_same_vertex x w -> at_same_vertex y (c w) = false.
  by move=> wU nw; have [|] := I w; rewrite !inE ?nw // => /andP[/negbTE].
case: ifP => [cz|/negbT nz]; case: ifP => [ct|/negbT nt]; first exact: turned_inj.
- by move=> E; have := off t tU nt; rewrite -E at_y.
- by move=> E; have := off z zU nz; rewrite E at_y.
by apply: J; rewrite !inE ?nz ?nt.
Qed.
End Vertex.

Lemma turns_by_image U V x : whole_vertices U -> whole_vertices V -> x \in U ->
  #|turnings_of U V| =
    \sum_(y in V :&: class x) #|turnings_of (U :\: darts_round x) (V :\: darts_round y)|.
Proof.
move=> cU cV xU; rewrite -sum1_card (partition_big (fun f => f x) (mem (V :&: class x))) /= => [|f].
  apply: eq_bigr => y; rewrite !inE => /andP[yV xy]; rewrite -(turns_from cU cV xU yV xy) -sum1_card.
  by apply: eq_bigl => f; rewrite !inE.
by rewrite inE => /turnsP[_ I _]; rewrite !inE; have [-> _ ->] := I x xU.
Qed.
(* ---- The vertices of the quotient ---- *)
Definition vertex_class x := [set y | [exists z, at_same_vertex x z && indistinct z y]].
Definition vertex_classes := [set vertex_class x | x in G].
Definition vertices_of B U := #|[set z in U :&: B | froot sigma z == z]|.
Definition cone_of B := if [pick x in B] is Some x then cone x else 0.
Definition sheets_of B := vertices_of B setT.

Lemma vertex_classP x y : reflect (exists2 z, at_same_vertex x z & indistinct z y) (y \in vertex_class x).
Proof.
rewrite inE; apply: (iffP existsP) => [[z /andP[]]|[z c k]]; first by exists z.
by exists z; rewrite c.
Qed.

Lemma vertex_class_back x y : y \in vertex_class x -> exists2 z, at_same_vertex y z & indistinct x z.
Proof.
case/vertex_classP=> z c k; have c' : at_same_vertex z x by rewrite at_same_vertex_sym.
exists (iter (findex sigma z x) sigma y); first exact: fconnect_iter.
by rewrite -{1}(iter_findex c'); exact: indistinct_turn.
Qed.

Lemma vertex_class_same x y : y \in vertex_class x -> vertex_class y = vertex_class x.
Proof.
have half u v w : v \in vertex_class u -> w \in vertex_class v -> w \in vertex_class u.
  case/vertex_classP=> z c k /vertex_classP[z' c' k']; apply/vertex_classP.
  exists (iter (findex sigma v z') sigma z); first exact: connect_trans c (fconnect_iter _ _ _).
  by apply: trans k'; rewrite -{2}(iter_findex c'); exact: indistinct_turn.
move=> second_other; have xy : x \in vertex_class y.
  by have [z c k] := vertex_class_back second_other; apply/vertex_classP; exists z; rewrite // sym.
by apply/setP=> w; apply/idP/idP; exact: half.
Qed.

Lemma vertex_class_self x : x \in vertex_class x.
Proof. by apply/vertex_classP; exists x; [exact: connect0 | exact: refl]. Qed.

Lemma vertex_class_near x z : at_same_vertex x z -> z \in vertex_class x.
Proof. by move=> c; apply/vertex_classP; exists z; rewrite ?refl. Qed.

Lemma vertex_class_alike x z : indistinct x z -> z \in vertex_class x.
Proof. by move=> k; apply/vertex_classP; exists x; rewrite // /at_same_vertex connect0. Qed.

Lemma cone_ofE x : cone_of (vertex_class x) = cone x.
Proof.
rewrite /cone_of; case: pickP => [y /vertex_classP[z c k]|/(_ x)]; last by rewrite vertex_class_self.
by rewrite -(cone_class (@position_degree G d) k) -(cone_vertex (position_of d) c).
Qed.

Lemma root_same x z : (froot sigma x == froot sigma z) = at_same_vertex x z.
Proof. exact: (root_connect vsym). Qed.

Lemma class_by_vertices V x : whole_vertices V ->
  #|V :&: class x| = vertices_of (vertex_class x) V * cone x.
Proof.
move=> cV; pose R := [set z in V :&: vertex_class x | froot sigma z == z].
rewrite -sum1_card (partition_big (froot sigma) (mem R)) /= => [|z].
  rewrite -sum_nat_const; apply: eq_bigr => r; rewrite !inE -andbA => /and3P[rV rB /eqP rr].
  have [z c k] : exists2 z, at_same_vertex r z & indistinct x z.
    by apply: vertex_class_back; rewrite inE.
  rewrite (cone_class (@position_degree G d) k) sum1_card; apply: eq_card => t.
  rewrite [LHS]unfold_in /= !inE.
  have -> : (froot sigma t == r) = at_same_vertex t r by rewrite -root_same rr.
  rewrite (indistinct_left _ k).
  have -> : at_same_vertex t r = at_same_vertex z t.
    rewrite at_same_vertex_sym; exact: (same_connect vsym c).
  rewrite andbC; case c' : (at_same_vertex z t) => //=.
  by rewrite (whole_vertex cV (connect_trans c c')) rV.
rewrite !inE => /andP[zV k]; have c : at_same_vertex z (froot sigma z) by exact: connect_root.
rewrite (whole_vertex cV c) zV (root_root vsym) eqxx andbT /=.
apply/existsP; exists (iter (findex sigma z (froot sigma z)) sigma x).
rewrite {1}/at_same_vertex fconnect_iter /=.
by rewrite -{2}(iter_findex c); exact: indistinct_turn.
Qed.

Lemma vertices_here U x : whole_vertices U -> x \in U ->
  vertices_of (vertex_class x) U = (vertices_of (vertex_class x) (U :\: darts_round x)).+1.
Proof.
move=> cU xU; have c : at_same_vertex x (froot sigma x) by exact: connect_root.
rewrite /vertices_of (cardsD1 (froot sigma x)) !in_set (whole_vertex cU c) xU (root_root vsym) eqxx.
have := vertex_class_near c; rewrite in_set => -> /=; congr (_.+1); apply: eq_card => z; rewrite !in_set.
have [/eqP rz|] := boolP (froot sigma z == z); rewrite ?andbF // !andbT.
by rewrite -root_same rz [_ == z]eq_sym andbA.
Qed.

Lemma vertices_elsewhere U x B : B \in vertex_classes -> B != vertex_class x ->
  vertices_of B (U :\: darts_round x) = vertices_of B U.
Proof.
case/imsetP=> w _ -> ne; apply: eq_card => z; rewrite !in_set; congr (_ && _).
have [zB|] := boolP [exists t, at_same_vertex w t && indistinct t z]; rewrite ?andbF // !andbT.
suff -> : at_same_vertex x z = false by [].
apply: contraNF ne => /vertex_class_near zx; rewrite -(vertex_class_same zx).
by rewrite (@vertex_class_same w z) // inE.
Qed.

Definition turns_weight B U := cone_of B ^ vertices_of B U * (vertices_of B U)`!.

Lemma turnings_of_none V : #|turnings_of set0 V| = 1.
Proof.
rewrite (_ : turnings_of set0 V = [set [ffun z => z]]) ?cards1 //; apply/setP=> f; rewrite !inE.
apply/turnsP/eqP=> [[O _ _]|->]; first by apply/ffunP=> z; rewrite ffunE; apply: O; rewrite inE.
by split=> [z _|z|z t]; rewrite ?inE // ffunE.
Qed.

Theorem turns_counted U V : whole_vertices U -> whole_vertices V ->
  (forall B, B \in vertex_classes -> vertices_of B U = vertices_of B V) ->
  #|turnings_of U V| = \prod_(B in vertex_classes) turns_weight B U.
Proof.
have [n] := ubnP #|U|; elim: n U V => // n IH U V lt cU cV E.
have [U0|[x xU]] := set_0Vmem U.
  rewrite U0 turnings_of_none big1 // => B _; rewrite /turns_weight /vertices_of set0I.
  by rewrite (_ : [set z in set0 | _] = set0) ?cards0 //; apply/setP=> z; rewrite !inE.
have Bx : vertex_class x \in vertex_classes by apply: imset_f.
pose rest := \prod_(B in vertex_classes | B != vertex_class x) turns_weight B U.
pose v := vertices_of (vertex_class x) (U :\: darts_round x).
rewrite (turns_by_image cU cV xU) (bigD1 _ Bx) /= -/rest.
rewrite (eq_bigr (fun _ => cone x ^ v * v`! * rest)) => [|y]; last first.
  rewrite inE => /andP[yV]; rewrite inE => k; have yB := vertex_class_alike k.
  have same := vertex_class_same yB.
  have lt' : #|U :\: darts_round x| < n.
    apply: leq_trans (lt : #|U| <= n); apply/proper_card/properP; split; first exact: subsetDl.
    by exists x; rewrite ?inE // /at_same_vertex connect0.
  rewrite (IH _ _ lt' (whole_left x cU) (whole_left y cV)) => [|B BE].
    rewrite (bigD1 _ Bx) /= {1}/turns_weight cone_ofE -/v; congr (_ * _).
    by apply: eq_bigr => B /andP[BE ne]; rewrite /turns_weight vertices_elsewhere.
  have [->|ne] := eqVneq B (vertex_class x).
    by apply: succn_inj; rewrite -vertices_here // -same -vertices_here // same E.
  by rewrite !vertices_elsewhere ?same // E.
rewrite sum_nat_const class_by_vertices // -E // mulnA; congr (_ * _).
rewrite /turns_weight cone_ofE vertices_here // -/v expnS factS.
by rewrite [in LHS](mulnC v.+1) mulnACA.
Qed.

Theorem turnings_counted : #|[set f | turning d f]| =
  \prod_(B in vertex_classes | d \notin B) (cone_of B ^ sheets_of B * (sheets_of B)`!).
Proof.
have cU : whole_vertices (~: darts_round d) by move=> z; rewrite !inE vertex_next.
have -> : #|[set f | turning d f]| = #|turnings_of (~: darts_round d) (~: darts_round d)|.
  apply: eq_card => f; rewrite !inE; apply/turningP/turnsP=> [[i s k e]|[O I J]].
    have at_d z : at_same_vertex d z -> f z = z.
      move=> c; rewrite -(iter_findex c); elim: (findex _ _ _) => //= j; rewrite s => ->.
      by [].
    split=> [z|z|z t _ _]; rewrite ?inE ?negbK; [exact: at_d | | exact: i].
    by move=> nz; have [_ <-] := indistinct_senses (k z); split.
  have at_d z : at_same_vertex d z -> f z = z by move=> c; apply: O; rewrite !inE c.
  have off z : ~~ at_same_vertex d z -> ~~ at_same_vertex d (f z).
    by move=> nz; have [|] := I z; rewrite !inE.
  split=> [z t E|z|z|]; last by apply: at_d; exact: connect0.
  - have [cz|nz] := boolP (at_same_vertex d z); have [ct|nt] := boolP (at_same_vertex d t).
    + by rewrite -(at_d z cz) -(at_d t ct).
    + by have := off t nt; rewrite -E (at_d z cz) cz.
    + by have := off z nz; rewrite E (at_d t ct) ct.
    by apply: J => //; rewrite !inE.
  - have [c|nc] := boolP (at_same_vertex d z); first by rewrite !at_d // vertex_next.
    by have [|_ -> _] := I z; rewrite ?inE.
  have [c|nc] := boolP (at_same_vertex d z); first by rewrite at_d // refl.
  by have [|_ _] := I z; rewrite ?inE.
rewrite turns_counted // (bigID (fun B => d \in B)) /= big1 ?mul1n => [|B /andP[/imsetP[x _ ->] dB]].
  apply: eq_bigr => B /andP[/imsetP[x _ ->] dB].
  rewrite /turns_weight -setTD vertices_elsewhere ?imset_f //.
  by apply: contraNneq dB => ->; exact: vertex_class_self.
rewrite -(vertex_class_same dB) /turns_weight /vertices_of (_ : [set z in _ | _] = set0) ?cards0 //.
apply/setP=> z; rewrite in_set !in_setI in_setC in_set in_set0.
apply/negP=> /andP[/andP[nz /vertex_classP[t c k]] _].
by case/negP: nz; have := c; have [_ <-] := indistinct_senses k.
Qed.

Lemma sheets_by_cone x : sheets_of (vertex_class x) * cone x = lookalikes d.
Proof. by rewrite -class_by_vertices ?setTI; [exact: class_size | move=> z; rewrite !inE]. Qed.
End Turnings.
