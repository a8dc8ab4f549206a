(* ---------------------------------------------------------------------------------------------
   Breadth-first paths in S.                                             Algorithm 1, lines 4 and 9

     branch               a vertex found, the path to it, the dart it arrives by.
     tree S a             a branch for each vertex that can be reached from dart a.
     route S a v          a breadth-first path in S from dart a to vertex v, with the dart that it
                          arrives by.
     route_or_else S w a v    the path w if it leads from a to v in fewer steps than S has vertices,
                          else route S a v.

     good T               T holds paths, each no longer than its place in T, to different vertices.
     routeP               a vertex that can be reached is: by a path shorter than S has vertices.
     route_or_elseP       the same, whatever path is proposed.
   --------------------------------------------------------------------------------------------- *)
From mathcomp Require Import all_ssreflect.
From Allworlds Require Import Model Maps PartialMaps Paths.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Section Route.
Variable S : partial_map.

Definition branch := (nat * (seq nat * dart))%type.
Definition no_branch : branch := (0, ([::], (0, 0))).

Definition visit (w : seq nat) (c : dart) (T : seq branch) k :=
  if partner S (turn S k c) is Some g then
    if g.1 \in unzip1 T then T else rcons T (g.1, (rcons w k, g))
  else T.
(* the turns from c to the darts of its vertex, in the order of their places *)
Definition round (c : dart) :=
  [seq degree_in S c.1 - c.2 + i | i <- iota 0 (degree_in S c.1)].
Fixpoint grow fuel i (T : seq branch) :=
  if fuel is fuel'.+1 then
    if i < size T then
      let t := (nth no_branch T i).2 in
      grow fuel' i.+1 (foldl (visit t.1 t.2) T (round t.2))
    else T
  else T.
Definition tree (a : dart) := grow (size (degrees S)) 0 [:: (a.1, ([::], a))].
Definition route a v := let T := tree a in (nth no_branch T (index v (unzip1 T))).2.

(* the path w, if it is one *)
Definition route_or_else w a v :=
  if follow S w a is Some f then
    if (f.1 == v) && (size w < size (degrees S)) then (w, f) else route a v
  else route a v.
End Route.

(* ---- Breadth-first search finds every vertex that can be reached ---- *)
Section RouteP.
Variables (S : partial_map) (a : dart).
Hypothesis ka : known S a.
Hypothesis Hl : forall x y, partner S x = Some y -> known S y.
Definition good (T : seq branch) := uniq (unzip1 T) /\ forall j, j < size T ->
  let t := nth no_branch T j in
  [/\ follow S t.2.1 a = Some t.2.2, t.2.2.1 = t.1, known S t.2.2 & size t.2.1 <= j].
Lemma visits w c ks T : follow S w a = Some c -> size w < size T -> good T ->
  exists X, [/\ foldl (visit S w c) T ks = T ++ X, good (T ++ X) &
    forall k g, k \in ks -> partner S (turn S k c) = Some g -> g.1 \in unzip1 (T ++ X)].
Proof.
move=> R; elim: ks T => [|k ks IH] T sw G /=; first by exists [::]; rewrite cats0.
have [Y [E GY HY]] : exists Y, [/\ visit S w c T k = T ++ Y, good (T ++ Y) &
    forall g, partner S (turn S k c) = Some g -> g.1 \in unzip1 (T ++ Y)].
  rewrite /visit; case L: (partner S _) => [g|]; last by exists [::]; rewrite cats0.
  case: ifP => gT; first by exists [::]; rewrite cats0; split=> // g' [<-].
  exists [:: (g.1, (rcons w k, g))]; rewrite cats1; split=> //; last first.
    by move=> g' [<-]; rewrite /unzip1 map_rcons mem_rcons inE eqxx.
  have [U H] := G; split; first by rewrite /unzip1 map_rcons rcons_uniq gT.
  move=> j; rewrite size_rcons nth_rcons ltnS leq_eqVlt => /orP[/eqP->|lj]; last by rewrite lj;
    exact: H.
  rewrite ltnn eqxx /=; split=> //; last by rewrite size_rcons.
    by rewrite -cats1 (follow_cat _ R) /= L.
  exact: (Hl L).
have [|X [EX GX HX]] := IH (T ++ Y) _ GY; first by rewrite size_cat ltn_addr.
rewrite E; exists (Y ++ X); rewrite catA; split=> // k' g; rewrite inE => /orP[/eqP->|] L;
  last exact: HX.
by rewrite /unzip1 map_cat mem_cat HY.
Qed.

(* the neighbours of the first i vertices have been found *)
Definition done_to i (T : seq branch) := forall j, j < i -> forall p g,
  let c := (nth no_branch T j).2.2 in
  p < degree_in S c.1 -> partner S (c.1, p) = Some g -> g.1 \in unzip1 T.
Lemma good_size T : good T -> size T <= size (degrees S).
Proof.
case=> U H; rewrite -(size_map fst) -[X in _ <= X](size_iota 0); apply: uniq_leq_size => // v.
case/(nthP 0)=> j; rewrite size_map => lj <-; rewrite (nth_map no_branch) // mem_iota /=.
by have [_ <- /andP[]] := H j lj.
Qed.

Lemma growP fuel i T : good T -> i <= size T -> size (degrees S) <= fuel + i -> done_to i T ->
  let T' := grow S fuel i T in [/\ good T', done_to (size T') T' & {subset unzip1 T <= unzip1 T'}].
Proof.
elim: fuel i T => [|fl IH] i T G li ns Dn /=.
  have E : i = size T by apply/eqP; rewrite eqn_leq li /=; exact: leq_trans (good_size G) ns.
  by rewrite -E; split.
case: ifP => [lt|/negbT]; last first.
  by rewrite -leqNgt => le; have E : i = size T by [apply/eqP; rewrite eqn_leq li]; rewrite -E; split.
set t := (nth no_branch T i).2; have [U H] := G; have [R e1 kc sw] := H i lt.
have [X [E GX HX]] := visits (round S t.2) R (leq_ltn_trans sw lt) G.
rewrite E; have [|||A B C] := IH i.+1 (T ++ X) GX.
- by rewrite size_cat ltn_addr.
- by rewrite addnS -addSn.
- move=> j; rewrite ltnS leq_eqVlt => /orP[/eqP->|lj] p g; rewrite /= nth_cat.
    rewrite lt -/t => lp L; have [lc _] := andP kc.
    apply: (HX (degree_in S t.2.1 - t.2.2 + p)); first by rewrite map_f ?mem_iota.
    by rewrite (@turn_to S t.2 (t.2.1, p)) //; apply/andP.
  rewrite (ltn_trans lj lt) => lp L; rewrite /unzip1 map_cat mem_cat; apply/orP; left.
  exact: (Dn j lj p g).
by split=> // v vT; apply: C; rewrite /unzip1 map_cat mem_cat vT.
Qed.

Lemma routeP v : joined S a v -> let way := route S a v in
  [/\ follow S way.1 a = Some way.2, way.2.1 = v & size way.1 < size (degrees S)].
Proof.
move=> [w [f [R fv]]]; rewrite /route; set T := tree S a.
have [||||G Dn Sub] := @growP (size (degrees S)) 0 [:: (a.1, ([::], a))] => //.
- by split=> // -[|j].
- by rewrite addn0.
rewrite -[grow _ _ _ _]/T in G Dn Sub.
have cl x : known S x -> x.1 \in unzip1 T -> forall w f, follow S w x = Some f -> f.1 \in unzip1 T.
  move=> kx xT w' f'; elim: w' x kx xT => [|k w' IH] x kx xT /=; first by case=> <-.
  case L: (partner S _) => [g|] //; apply: IH; first exact: (Hl L).
  have [U H] := G; set j := index x.1 (unzip1 T).
  have lj : j < size T by rewrite -(size_map fst) index_mem.
  have [_ c1 kc _] := H j lj; set c := (nth no_branch T j).2.2 in c1 kc.
  have cx : c.1 = x.1.
    by rewrite c1 -(nth_map no_branch 0 fst) // nth_index.
  have dx : 0 < degree_in S x.1 by case/andP: kx => _; case: (degree_in S _).
  by apply: (Dn j lj ((x.2 + k) %% degree_in S x.1)); rewrite -/c cx ?ltn_mod.
have vT : v \in unzip1 T by rewrite -fv; apply: (cl a ka _ w f R); apply: Sub; rewrite /= inE.
have lj : index v (unzip1 T) < size T by rewrite -(size_map fst) index_mem.
have [U H] := G; have [A B _ C] := H _ lj; split=> //.
  by rewrite B -(nth_map no_branch 0 fst) // nth_index.
exact: leq_ltn_trans C (leq_trans lj (good_size G)).
Qed.

Lemma route_or_elseP w v : joined S a v -> let way := route_or_else S w a v in
  [/\ follow S way.1 a = Some way.2, way.2.1 = v & size way.1 < size (degrees S)].
Proof.
move/routeP=> R; rewrite /route_or_else; case F: (follow S w a) => [f|] //.
by case: ifP => // /andP[/eqP fv sw].
Qed.
End RouteP.
