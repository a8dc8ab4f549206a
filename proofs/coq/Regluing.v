(* ---------------------------------------------------------------------------------------------
   The worlds that look like a given one: its own darts, glued otherwise.               Section III

   Position only.  Keep the darts and the vertices of a world, and let beta be the other end of an edge
   instead of alpha, where beta x always looks like alpha x.  That is a world again, and it looks the
   same; and every world that looks the same is one of these.  So the worlds that a robot cannot tell
   from its own can be listed.

     reglued              the world with beta for alpha; reglued_connected: it is connected.
     reglued_alike        it looks the same.
     matching             where the members of two finite sets fall into blocks, equally many of both to a
                          block, they can be paired within the blocks.
     alike_reglued        every world that looks the same is a regluing.
   --------------------------------------------------------------------------------------------- *)
From mathcomp Require Import all_ssreflect.
From Allworlds Require Import Model Maps Percepts RootedMaps Indistinguishable PositionTwins Ambiguity.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(* ---- A regluing is a world that looks the same ---- *)
Section Reglued.
Variables (G : combinatorial_map) (d : G) (beta : G -> G).
Local Notation indistinct := (indistinct (position_of d) (position_of d)).
Hypotheses (betaK : involutive beta) (beta_neq : forall x, beta x != x).
Hypothesis beta_near : forall x, indistinct (alpha x) (beta x).

Lemma reglued_home x : exists2 y, connect (adjacent sigma beta) x y & at_same_vertex d y.
Proof.
have step_sigma z : connect (adjacent sigma beta) z (sigma z).
  by apply: connect1; rewrite /adjacent eqxx.
have step_beta z : connect (adjacent sigma beta) z (beta z).
  by apply: connect1; rewrite /adjacent eqxx orbT.
suff H z : connect (adjacent sigma alpha) z d -> forall u, indistinct z u ->
    exists2 y, connect (adjacent sigma beta) u y & at_same_vertex d y.
  by apply: (H x); [exact: connected_map | exact: indistinct_refl].
case/connectP=> p; elim: p z => [|q p IH] z /=.
  by move=> _ <- u du; exists u; [exact: connect0 | exact: lookalikes_at_v0].
case/andP=> /orP[]/eqP-> P L u zu.
  have [y c at0] := IH _ P L (sigma u) (indistinct_sigma zu).
  by exists y => //; exact: connect_trans (step_sigma u) c.
have [|y c at0] := IH _ P L (beta u).
  by apply: indistinct_trans (beta_near u); exact: indistinct_alpha.
by exists y => //; exact: connect_trans (step_beta u) c.
Qed.

Lemma reglued_connected x y : connect (adjacent sigma beta) x y.
Proof.
have sym := adjacent_connect_sym (@sigma_inj G) betaK.
have home z : connect (adjacent sigma beta) z d.
  have [u c /iter_findex] := reglued_home z; set j := findex _ _ _ => E.
  apply: connect_trans c _; rewrite sym -E; elim: (j) => [|i IH]; first exact: connect0.
  by apply: connect_trans IH (connect1 _); rewrite /adjacent eqxx.
by apply: connect_trans (home x) _; rewrite sym; exact: home.
Qed.

Definition reglued := CombinatorialMap (@sigma_inj G) betaK beta_neq reglued_connected.

(* each dart looks as before *)
Lemma reglued_same x : Ambiguity.indistinct (position_of d) (position_of (d : reglued)) x x.
Proof.
apply/(indistinct_alikeP _ _ d (d : reglued)).
apply: (@bisimulation_alike _ (rooted d) (rooted (d : reglued)) _ _ (fun u v : G => indistinct u v)).
- by move=> u v uv; split=> //; rewrite (indistinct_senses uv).
- by move=> u v; exact: indistinct_sigma.
- by move=> u v uv; apply: indistinct_trans (beta_near v); exact: indistinct_alpha.
exact: indistinct_refl.
Qed.

Theorem reglued_alike : look_alike d (d : reglued).
Proof. by have /(indistinct_alikeP _ _ d (d : reglued))[] := reglued_same d. Qed.
End Reglued.

(* ---- Pairing within blocks ---- *)
Section Matching.
Variables (A B : finType) (b0 : B) (domain : pred A) (S : A -> B -> bool).
Definition in_block a a' := [exists b, S a b && S a' b].
Hypothesis blocks : forall a a' b b', S a b -> S a' b -> S a b' -> S a' b'.
Hypothesis some : forall a, domain a -> exists b, S a b.
Hypothesis enough : forall a, domain a ->
  #|[pred a' | domain a' && in_block a a']| <= #|[pred b | S a b]|.

Lemma matching : exists phi : A -> B,
  (forall a, domain a -> S a (phi a)) /\ {in domain &, injective phi}.
Proof.
pose others a := enum [pred a' | domain a' && in_block a a'].
pose images a := enum [pred b | S a b].
pose phi a := nth b0 (images a) (index a (others a)).
have mem a : domain a -> a \in others a.
  move=> da; rewrite mem_enum inE da; have [b Sb] := some da.
  by apply/existsP; exists b; rewrite Sb.
have lt a : domain a -> index a (others a) < size (images a).
  move=> da; rewrite /images -cardE; apply: leq_trans (enough da).
  by rewrite cardE index_mem mem.
have phiS a : domain a -> S a (phi a) by move/lt/(mem_nth b0); rewrite mem_enum.
exists phi; split=> // a a' da da' E.
have Sa := phiS a da; have Sa' := phiS a' da'; rewrite -E in Sa'.
have eqS b : S a b = S a' b by apply/idP/idP; [exact: blocks Sa Sa' | exact: blocks Sa' Sa].
have eqO : others a = others a'.
  apply: eq_enum => c; rewrite !inE; congr (_ && _).
  by apply/existsP/existsP=> -[b /andP[p q]]; exists b; rewrite q andbT ?eqS // -eqS.
have eqI : images a = images a' by apply: eq_enum => b; rewrite !inE eqS.
have /eqP : phi a = phi a' by [].
rewrite /phi eqI nth_uniq ?enum_uniq ?lt // -?eqI ?lt // eqO => /eqP ii.
have ma := mem a da; rewrite eqO in ma.
by rewrite -(nth_index a ma) ii nth_index // mem.
Qed.
End Matching.

(* ---- Every world that looks the same is a regluing ---- *)
Section Alike.
Variables (G H : combinatorial_map) (d : G) (e : H).
Hypothesis A : look_alike d e.
Local Notation indistinct_G := (indistinct (position_of d) (position_of d)).
Local Notation indistinct_H := (indistinct (position_of e) (position_of e)).

Local Notation R := (indistinct (position_of d) (position_of e)).
Local Notation alikeP := (indistinct_alikeP (position_of d) (position_of e) d e).

Lemma alike_start : R d e. Proof. by apply/alikeP. Qed.

Lemma lookalike_left x x' y : R x y -> R x' y = indistinct_G x x'.
Proof.
move=> /alikeP[_ _ E]; apply/alikeP/(indistinctP _ d) => [[_ _ E'] w|E'].
  by rewrite E E'.
by split=> // w; rewrite -E' E.
Qed.

Lemma lookalike_right x y y' : R x y -> R x y' = indistinct_H y y'.
Proof.
move=> /alikeP[_ _ E]; apply/alikeP/(indistinctP _ e) => [[_ _ E'] w|E'].
  by rewrite -E E'.
by split=> // w; rewrite E E'.
Qed.

Lemma lookalike_some x : exists y, R x y.
Proof.
apply: (@everywhere G (fun x => exists y, R x y) d) => [|u [v r]|u [v r]].
- by exists e; exact: alike_start.
- by exists (sigma v); exact: indistinct_sigma.
by exists (alpha v); exact: indistinct_alpha.
Qed.

Lemma lookalike_some' y : exists x, R x y.
Proof.
apply: (@everywhere H (fun y => exists x, R x y) e) => [|v [u r]|v [u r]].
- by exists d; exact: alike_start.
- by exists (sigma u); exact: indistinct_sigma.
by exists (alpha u); exact: indistinct_alpha.
Qed.

(* each dart looks like as many darts of the other world *)
Lemma alike_count x : #|[pred y | R x y]| = lookalikes e.
Proof.
have [y r] := lookalike_some x; rewrite (eq_card (fun y' => lookalike_right y' r)).
by rewrite /lookalikes -(class_size _ y e) cardsE.
Qed.

Lemma alike_count' y : #|[pred x | R x y]| = lookalikes d.
Proof.
have [x r] := lookalike_some' y; rewrite (eq_card (fun x' => lookalike_left x' r)).
by rewrite /lookalikes -(class_size _ x d) cardsE.
Qed.

Lemma count_pairs (p : pred G) (q : pred H) : (forall x y, R x y -> p x = q y) ->
  #|p| * lookalikes e = #|q| * lookalikes d.
Proof.
move=> pq; have := sum_nat_const p (lookalikes e); have := sum_nat_const q (lookalikes d) => /= <- <-.
rewrite (eq_bigr (fun x => \sum_(y | R x y) 1)) => [|x _]; last by rewrite sum1_card alike_count.
rewrite [RHS](eq_bigr (fun y => \sum_(x | R x y) 1)) => [|y _]; last by rewrite sum1_card alike_count'.
rewrite (exchange_big_dep (mem q)) /= => [|x y px r]; last by rewrite unfold_in -(pq _ _ r).
apply: eq_bigr => y qy; apply: eq_bigl => x; rewrite andbC; case r: (R x y) => //=.
by rewrite unfold_in (pq _ _ r).
Qed.

Theorem alike_lookalikes : lookalikes d = lookalikes e.
Proof.
have := @count_pairs predT predT (fun _ _ _ => erefl); rewrite !cardT -!cardE.
rewrite -(alike_darts A) => /eqP; rewrite eqn_pmul2l => [/eqP->//|].
by apply/card_gt0P; exists d.
Qed.

(* the darts that look like one at the vertex of x *)
Definition near x := [pred x' | [exists z, at_same_vertex x z && indistinct_G z x']].
Definition near' x := [pred y | [exists z, at_same_vertex x z && R z y]].

Lemma near_count x : #|near x| = #|near' x|.
Proof.
have k0 : 0 < lookalikes e.
  by rewrite -(alike_count d); apply/card_gt0P; exists e; exact: alike_start.
apply/eqP.
rewrite -(eqn_pmul2r k0) (@count_pairs (near x) (near' x)) ?alike_lookalikes // => u v r.
by apply/existsP/existsP=> -[z /andP[c i]]; exists z; rewrite c /=; move: i;
  rewrite (lookalike_left z r) indistinct_sym.
Qed.

(* so there are as many vertices like that of x in both worlds *)
Lemma near_vertices (x : G) :
  #|[pred r | froots sigma r & near x r]| = #|[pred s | froots sigma s & near' x s]|.
Proof.
have cG : #|[pred r | froots sigma r & near x r]| * degree x = #|near x|.
  apply: (fcard_order_set (@sigma_inj G)); last first.
    apply: intro_closed; first exact: (fconnect_sym (@sigma_inj G)).
    move=> u v /eqP <- /existsP[z /andP[c i]]; apply/existsP; exists (sigma z).
    by rewrite indistinct_sigma // andbT; apply: connect_trans c _; exact: fconnect1.
  apply/subsetP=> u /existsP[z /andP[c i]]; rewrite inE -/(degree u).
  by have [<- _] := indistinct_senses i; rewrite (degree_same c).
have cH : #|[pred s | froots sigma s & near' x s]| * degree x = #|near' x|.
  apply: (fcard_order_set (@sigma_inj H)); last first.
    apply: intro_closed; first exact: (fconnect_sym (@sigma_inj H)).
    move=> u v /eqP <- /existsP[z /andP[c i]]; apply/existsP; exists (sigma z).
    by rewrite indistinct_sigma // andbT; apply: connect_trans c _; exact: fconnect1.
  apply/subsetP=> u /existsP[z /andP[c i]]; rewrite inE -/(degree u).
  by have [<- _] := indistinct_senses i; rewrite (degree_same c).
by apply/eqP; rewrite -(eqn_pmul2r (degree_gt0 x)) cG cH near_count.
Qed.

Lemma turned_vertex (K : combinatorial_map) j (x z : K) :
  at_same_vertex x z -> at_same_vertex x (iter j sigma z).
Proof. by move=> c; apply: connect_trans c (fconnect_iter _ _ _). Qed.

(* a dart at the vertex of x, and one of the other world that looks like it; different vertices go with
   different vertices *)
Lemma bases : exists b : G -> G * H, [/\ forall x, at_same_vertex x (b x).1, forall x, R (b x).1 (b x).2,
  forall x, b (sigma x) = b x, b d = (d, e) &
  forall x x', at_same_vertex (b x).2 (b x').2 -> at_same_vertex x x'].
Proof.
pose S r s := froots (@sigma H) s && near' r s.
have blocks a a' b b' : S a b -> S a' b -> S a b' -> S a' b'.
  case/andP=> _ /existsP[z /andP[c r]] /andP[_ /existsP[z1 /andP[c1 r1]]].
  case/andP=> rt /existsP[z2 /andP[c2 r2]].
  rewrite /S rt; apply/existsP; have := c; rewrite at_same_vertex_sym => c'.
  have c3 : at_same_vertex z z2 by exact: connect_trans c' c2.
  exists (iter (findex sigma z z2) sigma z1); rewrite turned_vertex //=.
  rewrite (lookalike_left _ r2) -{1}(iter_findex c3); apply: indistinct_turn.
  by rewrite -(lookalike_left _ r) r1.
have some a : froots sigma a -> exists b, S a b.
  move=> _; have [y r] := lookalike_some a; exists (froot sigma y).
  rewrite /S (roots_root (fconnect_sym (@sigma_inj H))); apply/existsP.
  have c : fconnect sigma y (froot sigma y) by exact: connect_root.
  exists (iter (findex sigma y (froot sigma y)) sigma a).
  rewrite turned_vertex /=; last exact: connect0.
  by rewrite -{2}(iter_findex c) indistinct_turn.
have [|phi [phiS phiI]] := @matching G H e (froots (@sigma G)) S blocks some.
  move=> a _; apply: (@leq_trans #|[pred r | froots sigma r & near a r]|); last first.
    by rewrite near_vertices; apply/subset_leq_card/subsetP=> s; rewrite !inE.
  apply/subset_leq_card/subsetP=> r; rewrite !inE => /andP[-> /existsP[s /andP[]]] /=.
  case/andP=> _ /existsP[z /andP[c rz]] /andP[_ /existsP[z' /andP[c' rz']]].
  rewrite at_same_vertex_sym in c'; apply/existsP; exists (iter (findex sigma z' r) sigma z).
  rewrite turned_vertex //= -{2}(iter_findex c'); apply: indistinct_turn.
  by rewrite -(lookalike_left _ rz).
have at_root (x : G) : at_same_vertex x (froot sigma x) by exact: connect_root.
have same_root (x x' : G) : at_same_vertex x x' -> froot sigma x = froot sigma x'.
  by move=> c; apply/eqP; rewrite (root_connect (fconnect_sym (@sigma_inj G))).
have root_v0 (x y : G) : froot sigma x = froot sigma y -> at_same_vertex x y.
  by move=> E; rewrite /at_same_vertex -(root_connect (fconnect_sym (@sigma_inj G))) E.
pose z0 r := odflt r [pick z | at_same_vertex r z && R z (phi r)].
have z0P r : froots sigma r -> at_same_vertex r (z0 r) && R (z0 r) (phi r).
  move=> rr; have /andP[_ /existsP[z H0]] := phiS r rr.
  by rewrite /z0; case: pickP => [u //|/(_ z)]; rewrite H0.
have rooted_x (x : G) : froots sigma (froot sigma x) by exact: (roots_root (fconnect_sym (@sigma_inj G))).
exists (fun x => if at_same_vertex d x then (d, e) else (z0 (froot sigma x), phi (froot sigma x))).
have at0 x y : R x y -> at_same_vertex d x = at_same_vertex e y.
  by move/indistinct_senses => -[].
split=> [x|x|x||x x'].
- case: ifP => /= [c|_]; first by rewrite at_same_vertex_sym.
  have /andP[c _] := z0P _ (rooted_x x); exact: connect_trans (at_root x) c.
- by case: ifP => /= _; [exact: alike_start | have /andP[_ r] := z0P _ (rooted_x x)].
- have c : at_same_vertex x (sigma x) by exact: fconnect1.
  rewrite -(same_root _ _ c); congr (if _ then _ else _).
  rewrite ![at_same_vertex d _]at_same_vertex_sym /at_same_vertex.
  by rewrite (same_connect (fconnect_sym (@sigma_inj G)) c).
- by rewrite /at_same_vertex connect0.
have v0phi y : ~~ at_same_vertex d y -> at_same_vertex e (phi (froot sigma y)) = false.
  move=> N; have /andP[c r] := z0P _ (rooted_x y); rewrite -(at0 _ _ r); apply: contraNF N => c1.
  rewrite at_same_vertex_sym in c1; rewrite at_same_vertex_sym.
  exact: connect_trans (at_root y) (connect_trans c c1).
case: ifP => [c|/negbT N]; case: ifP => [c'|/negbT N'] /= h.
- by rewrite at_same_vertex_sym in c; exact: connect_trans c c'.
- by rewrite v0phi in h.
- by rewrite at_same_vertex_sym v0phi in h.
apply: root_v0; apply: phiI; [exact: rooted_x | exact: rooted_x |].
have /andP[/eqP <- _] := phiS _ (rooted_x x); have /andP[/eqP <- _] := phiS _ (rooted_x x').
by apply/eqP; rewrite (root_connect (fconnect_sym (@sigma_inj H))).
Qed.

(* a bijection of the darts that keeps turns, looks and the start *)
Lemma turning_bijection : exists (f : G -> H) (g : H -> G), [/\ cancel f g, cancel g f,
  forall x, f (sigma x) = sigma (f x), forall x, R x (f x) & f d = e].
Proof.
have [b [bG bR bs bd bH]] := bases.
pose f x := iter (findex sigma (b x).1 x) sigma (b x).2.
have here x : fconnect sigma (b x).1 x by have := bG x; rewrite at_same_vertex_sym.
have deg x : degree (b x).2 = degree (b x).1 by have [-> _] := indistinct_senses (bR x).
have fs x : f (sigma x) = sigma (f x).
  rewrite /f bs -iterS; set j := findex _ _ x; rewrite -[RHS]turn_modulo_degree deg.
  have lt : j.+1 %% degree (b x).1 < degree (b x).1 by rewrite ltn_mod degree_gt0.
  have E : sigma x = iter (j.+1 %% degree (b x).1) sigma (b x).1.
    by rewrite turn_modulo_degree iterS iter_findex.
  by rewrite E (findex_iter lt).
have fR x : R x (f x) by rewrite -{1}(iter_findex (here x)); exact: indistinct_turn.
have bE x x' : at_same_vertex x x' -> b x = b x'.
  by move/iter_findex <-; elim: (findex _ _ _) => //= j ->; rewrite bs.
have fi : injective f.
  move=> x x' E; have c : at_same_vertex (b x).2 (b x').2.
    apply: (connect_trans (fconnect_iter sigma (findex sigma (b x).1 x) _)); rewrite -/(f x) E.
    by rewrite (fconnect_sym sigma_inj); exact: fconnect_iter.
  have bb := bE _ _ (bH _ _ c); have := here x'; rewrite -bb => h'.
  rewrite -(iter_findex (here x)) -(iter_findex h'); move: E; rewrite /f -bb.
  have lt u : fconnect sigma (b x).1 u -> findex sigma (b x).1 u < degree (b x).2.
    by move=> cu; rewrite deg; exact: findex_max.
  by move/(congr1 (findex sigma (b x).2)); rewrite !findex_iter ?lt ?here // => ->.
have [g fK gK] : bijective f by apply: inj_card_bij fi _; rewrite (alike_darts A).
by exists f, g; split=> //; rewrite /f bd findex0.
Qed.

Theorem alike_reglued : exists (beta : G -> G) (betaK : involutive beta)
  (beta_neq : forall x, beta x != x) (near : forall x, indistinct_G (alpha x) (beta x)),
  isomorphic (rooted (d : reglued betaK beta_neq near)) (rooted e).
Proof.
have [f [g [fK gK fs fR fd]]] := turning_bijection.
pose beta x := g (alpha (f x)).
have betaK : involutive beta by move=> x; rewrite /beta gK alphaK fK.
have beta_neq x : beta x != x.
  by apply/eqP=> /(congr1 f); rewrite /beta gK => /eqP; rewrite (negbTE (alpha_neq _)).
have near x : indistinct_G (alpha x) (beta x).
  by rewrite -(lookalike_left _ (indistinct_alpha (fR x))) -[X in R _ X]gK; exact: fR.
exists beta, betaK, beta_neq, near; exists f, g; split=> [x _|y _|] //=.
by split=> //; rewrite ?fs // /beta gK.
Qed.
End Alike.

(* a world is unambiguous, place included, if all its regluings are the world itself *)
Corollary unambiguous_regluings (G : combinatorial_map) (d : G) : unambiguous d <->
  forall (beta : G -> G) (betaK : involutive beta) (beta_neq : forall x, beta x != x)
    (near : forall x, indistinct (position_of d) (position_of d) (alpha x) (beta x)),
  isomorphic (rooted d) (rooted (d : reglued betaK beta_neq near)).
Proof.
split=> [U beta betaK beta_neq near|all H e A]; first by apply: U; exact: reglued_alike.
have [beta [betaK [beta_neq [near I]]]] := alike_reglued A.
exact: isomorphic_trans (all beta betaK beta_neq near) I.
Qed.
