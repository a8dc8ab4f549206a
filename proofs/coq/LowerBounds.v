(* ---------------------------------------------------------------------------------------------
   Lower bounds for every explorer that is right in all worlds with a directional lighthouse.
                                                                                        Section VI

   n, m: the numbers of vertices and edges of the world that it is in.  Colour edges; two copies of
   the world, with every coloured edge led over into the other copy, are a world of twice the size,
   provided that the coloured edges are not all the edges between some vertices and the others.  Mark
   v0 in one copy only.  Where the robot has come back to v0 each time after an even number of
   crossings of coloured edges, it has sensed nothing that tells the two worlds apart.  There are 2^m
   colourings, 2^(n-1) of them separate vertices, and k returns tell apart 2^k at most: so m <= k+n-1.

     voltage_world c      the world of two copies, for a colouring c; its darts are (dart, copy).
     quiet c w d b        the motions w from d, begun in copy b, enter v0 in the first copy only.
     upper c              what is reached in the second copy; disconnected_potential: if the copies are
                          not connected, c separates the vertices of upper from the others.
     path_from_start      v0 lies at the end of a path of L edges; level: how far on the path, L from its
                          other end on; up: the darts of the path that lead away from v0.
     returns              the entries into v0 after the far end of the path has been reached.
     entries              all entries into v0.
     longer W, at_end_of_path L W   W with an edge before v0; with L edges before it, v0 at their end.
     bouquet k            one vertex with k+1 loops.

     edges_at_most_motions   at least m motions.
     returns_at_least     at least m-n+1 returns from beyond the path.
     entries_at_least     at least m-n+1 entries into v0.
     far_cycles_cost      at least 2 L (m-n+1) motions where v0 is at the end of a path of L edges.
     path_costs_every_cycle  the same for any world W put at the end of such a path, m and n of W.
     algorithm1_right_everywhere, algorithm1_log_folds   Algorithm 1 is such an explorer, so its log
                          leaves no dart open.
     mn_lower_bound       worlds with m = 2(k+1) and n = k+2, for every k, which need m (n-1) motions.
   --------------------------------------------------------------------------------------------- *)
From mathcomp Require Import all_ssreflect.
From Allworlds Require Import Maps Percepts RootedMaps Explorers Algorithm Refinement Folding.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(* ---- At least m motions ---- *)
Section AtLeastOneMotionAnEdge.
Variables (E : Type) (meaning : E -> rooted_map) (X : explorer percept E).
Hypothesis right_X : right_everywhere meaning X.

Theorem edges_at_most_motions (W : lighthouse_world) fuel t e z :
  episode X (rooted (@start W)) (@percept_of W) fuel = (t, Some e, z) -> edges W <= size t.
Proof.
move=> R; have A := episode_agrees R; have nopen := right_explorer_log_folds right_X R.
set L := log_of W t in A nopen.
pose ends := [seq place W (crossing L i).1 | i <- iota 0 (size t)] ++
             [seq place W (crossing L i).2 | i <- iota 0 (size t)].
rewrite -leq_double edges_double; apply: (@leq_trans (size ends)); last first.
  by rewrite size_cat !size_map size_iota addnn.
apply: leq_trans (card_size ends); apply: subset_leq_card; apply/subsetP=> x _.
have [p <-] := place_onto A nopen x; have /existsP[q] := nopen p; case/gluedP=> p' s c.
rewrite (folding_sound A s) mem_cat; case/hasP: c => i mi /orP[]/eqP ci.
  by apply/orP; left; apply/mapP; exists i; rewrite // -ci.
by apply/orP; right; apply/mapP; exists i; rewrite // -ci.
Qed.
End AtLeastOneMotionAnEdge.

(* ---- Covers with two sheets ---- *)
Section VoltageCover.
Variables (W : lighthouse_world) (c : W -> bool).
Hypothesis c_sym : forall d, c (alpha d) = c d.

Definition voltage_sigma (x : W * bool) := (sigma x.1, x.2).
Definition voltage_alpha (x : W * bool) := (alpha x.1, x.2 (+) c x.1).
Definition flip (x : W * bool) := (x.1, ~~ x.2).
Local Notation reach := (connect (adjacent voltage_sigma voltage_alpha)).
Local Notation v0 := (@start W).

Lemma voltage_sigma_inj : injective voltage_sigma.
Proof. by move=> [x b] [y b'] [/sigma_inj -> ->]. Qed.

Lemma voltage_alphaK : involutive voltage_alpha.
Proof. by move=> [x b]; rewrite /voltage_alpha /= alphaK c_sym -addbA addbb addbF. Qed.

Lemma voltage_alpha_neq x : voltage_alpha x != x.
Proof. by case: x => x b; apply/eqP=> -[]; have /eqP := alpha_neq x. Qed.

Lemma reach_sigma x : reach x (voltage_sigma x).
Proof. by apply: connect1; rewrite /adjacent eqxx. Qed.

Lemma reach_alpha x : reach x (voltage_alpha x).
Proof. by apply: connect1; rewrite /adjacent eqxx orbT. Qed.

Lemma reach_sym x y : reach x y -> reach y x.
Proof.
by rewrite (adjacent_connect_sym voltage_sigma_inj voltage_alphaK).
Qed.

Lemma reach_flip x y : reach x y -> reach (flip x) (flip y).
Proof.
case/connectP=> p + ->; elim: p x => //= z p IH x /andP[H /IH]; apply: connect_trans.
case/orP: H => /eqP->; first exact: reach_sigma (flip x).
by have := reach_alpha (flip x); rewrite /voltage_alpha /flip /= addNb.
Qed.

Lemma reach_one d : exists b, reach (v0, false) (d, b).
Proof.
move: d; apply: (@everywhere W _ v0) => [|x [b H]|x [b H]]; first by exists false.
  by exists b; apply: connect_trans H (reach_sigma (x, b)).
by exists (b (+) c x); apply: connect_trans H (reach_alpha (x, b)).
Qed.

(* c tells apart what a potential on the vertices does not *)
Definition upper := [set r in froots (@sigma W) | reach (v0, false) (r, true)].

Lemma upperE d : (froot sigma d \in upper) = reach (v0, false) (d, true).
Proof.
have H : fconnect sigma d (froot sigma d) by exact: connect_root.
have K : reach (d, true) (froot sigma d, true).
  rewrite -(iter_findex H); elim: (findex _ _ _) => //= k IH.
  exact: connect_trans IH (reach_sigma (iter k sigma d, true)).
have r : froot sigma d \in froots (@sigma W) by exact: (roots_root (fconnect_sym (@sigma_inj W))).
by rewrite inE r; apply/idP/idP=> R; [apply: connect_trans R (reach_sym K)
  | exact: connect_trans R K].
Qed.

Lemma disconnected_potential : ~~ reach (v0, false) (v0, true) ->
  froot sigma v0 \notin upper /\
  forall d, c d = (froot sigma d \in upper) (+) (froot sigma (alpha d) \in upper).
Proof.
move=> N; have one d : reach (v0, false) (d, false) = ~~ reach (v0, false) (d, true).
  apply/idP/idP=> H; last first.
    by have [[] R] := reach_one d; [rewrite R in H | exact: R].
  apply: contra N => K; apply: connect_trans K _; apply: reach_sym; exact: (reach_flip H).
have bit d b : reach (v0, false) (d, b) -> reach (v0, false) (d, true) = b.
  by case: b => // R; apply/negbTE; rewrite -one.
split=> [|d]; first by rewrite upperE.
rewrite !upperE; have [b R] := reach_one d; rewrite (bit _ _ R).
rewrite (bit _ (b (+) c d)); first by rewrite addbA addbb.
exact: connect_trans R (reach_alpha (d, b)).
Qed.

Hypothesis sheets : reach (v0, false) (v0, true).

Lemma voltage_connected x y : reach x y.
Proof.
have H z : reach (v0, false) z.
  case: z => d b; have [b' R] := reach_one d; case: (b =P b') => [->//|ne].
  apply: connect_trans sheets _; have -> : (d, b) = flip (d, b') by move: ne; case: (b); case: (b').
  exact: (reach_flip R).
exact: connect_trans (reach_sym (H x)) (H y).
Qed.

Definition voltage_cover := CombinatorialMap voltage_sigma_inj voltage_alphaK voltage_alpha_neq
  voltage_connected.

Lemma voltage_turn k d b : iter k (@sigma voltage_cover) (d, b) = (iter k sigma d, b).
Proof. by elim: k => //= k ->. Qed.

Lemma voltage_pointed : @at_same_vertex voltage_cover (v0, false) (pointed, false).
Proof.
have <- : iter (findex sigma v0 pointed) (@sigma voltage_cover) (v0, false) = (@pointed W, false).
  by rewrite voltage_turn iter_findex //; exact: pointed_at_v0.
exact: fconnect_iter.
Qed.

(* only the vertex over v0 in the lower sheet is marked *)
Definition voltage_world := @LighthouseWorld voltage_cover (v0, false) (pointed, false)
  voltage_pointed.

Lemma voltage_percept d b : (at_same_vertex v0 d -> b = false) ->
  percept_of ((d, b) : voltage_world) = percept_of d.
Proof.
move=> H; apply: percept_transfer => j; rewrite voltage_turn; first by rewrite xpair_eqE eqxx andbT.
rewrite xpair_eqE; case: (iter j sigma d =P pointed) => //= E; rewrite H // .
apply: connect_trans (@pointed_at_v0 W) _.
by rewrite -/(at_same_vertex _ _) at_same_vertex_sym -E; exact: fconnect_iter.
Qed.

(* the sheets in which v0 is entered *)
Fixpoint quiet w (d : W) b :=
  if w is k :: w' then
    let d' := motion k d in let b' := b (+) c (iter k sigma d) in
    (at_same_vertex v0 d' ==> ~~ b') && quiet w' d' b'
  else true.

Lemma quiet_percepts w d b : (at_same_vertex v0 d -> b = false) -> quiet w d b ->
  percepts_along w ((d, b) : voltage_world) = percepts_along w d.
Proof.
elim: w d b => [|k w IH] d b H /=; first by rewrite voltage_percept.
case/andP=> /implyP Q R; rewrite voltage_percept //; congr (_ :: _).
by rewrite /motion voltage_turn IH // => /Q/negbTE.
Qed.

Lemma quiet_agrees t : agrees W (log_of W t) -> quiet (unzip1 t) v0 false ->
  agrees voltage_world (log_of W t).
Proof. by rewrite /agrees => <- Q; exact: quiet_percepts. Qed.

Lemma voltage_not_isomorphic : ~ isomorphic (rooted v0) (rooted (@start voltage_world)).
Proof.
case=> f [g [F G _]]; have : #|W| = #|voltage_world|.
  by apply: (@bij_eq_card _ _ f); exists g => x; [have [] := F x isT | have [] := G x isT].
rewrite card_prod card_bool muln2 -addnn => /eqP; rewrite -{1}[#|W|]addn0 eqn_add2l eq_sym.
by apply/negP; rewrite -lt0n; apply/card_gt0P; exists v0.
Qed.
End VoltageCover.

(* ---- Worlds with v0 at the end of a path ---- *)

(* level: the distance from v0 on the path, L from its other end on; up j: the dart of the path that
   leads from level j to level j+1 *)
Record path_from_start (W : lighthouse_world) L (level : W -> nat) (up : nat -> W) : Prop :=
  PathFromStart {
  level_start : level start = 0;
  level_sigma : forall d, level (sigma d) = level d;
  level_max : forall d, level d <= L;
  level_step : forall d, level d <= (level (alpha d)).+1;
  level_path : forall d, level d < L ->
    (level (alpha d) = (level d).+1 /\ d = up (level d)) \/
    ((level (alpha d)).+1 = level d /\ alpha d = up (level (alpha d))) }.

Section Excursions.
Variables (W : lighthouse_world) (L : nat) (level : W -> nat) (up : nat -> W).
Hypothesis P : path_from_start L level up.
Local Notation v0 := (@start W).

(* how often v0 is entered from beyond the path: out tells whether the far end of the path has been
   reached since v0 was left *)
Fixpoint returns w d (out : bool) :=
  if w is k :: w' then
    let d' := motion k d in
    let out' := out || (level d' == L) in
    if at_same_vertex v0 d' then out' + returns w' d' (L == 0) else returns w' d' out'
  else 0.

Lemma level_turn k d : level (iter k sigma d) = level d.
Proof. by elim: k => //= k; rewrite (level_sigma P). Qed.

Lemma level_v0 d : at_same_vertex v0 d -> level d = 0.
Proof. by move/iter_findex <-; rewrite level_turn (level_start P). Qed.

(* every such return costs the path twice *)
Lemma returns_cost w d (out : bool) : (level d == L -> out) ->
  2 * L * returns w d out <= size w + (if out then 2 * L - level d else level d).
Proof.
elim: w d out => [|k w IH] d out far; first by rewrite muln0.
set d' := motion k d; rewrite [returns _ _ _]/=.
have s1 : level d' <= (level d).+1.
  by have := level_step P d'; rewrite /d' /motion alphaK level_turn.
have s2 : level d <= (level d').+1 by rewrite -(level_turn k d); exact: (level_step P).
have lL := level_max P d'; set out' := out || (level d' == L).
have p : (if out' then 2 * L - level d' else level d') <=
  (if out then 2 * L - level d else level d).+1.
  rewrite /out'; case: (out) => /=.
    rewrite -subSn; last by apply: leq_trans (level_max P d) _; rewrite leq_pmull.
    by rewrite -[2 * L - level d']subSS leq_sub2l.
  by case: eqP => // fl; rewrite fl mul2n -addnn addnK -fl.
case: ifP => [at0|_]; last first.
  by apply: leq_trans (IH d' out' _) _; [rewrite /out' => /eqP->; rewrite eqxx orbT
    | rewrite addSn -addnS leq_add2l].
have l0 := level_v0 at0; rewrite mulnDr.
have -> : size (k :: w) + (if out then 2 * L - level d else level d) =
  (if out then 2 * L - level d else level d).+1 + size w by rewrite /= addSn addnC addSn.
apply: leq_add.
  apply: leq_trans p; case: (out'); last by rewrite muln0.
  by rewrite muln1 l0 subn0.
have := IH d' (L == 0); rewrite l0 subn0 eq_sym; case: eqP => [-> _|_ H].
  by rewrite !muln0.
by have := H (fun e => e); rewrite addn0.
Qed.

Lemma returns_cost_start w : 2 * L * returns w v0 (L == 0) <= size w.
Proof.
have := @returns_cost w v0 (L == 0); rewrite (level_start P) eq_sym subn0 => /(_ (fun e => e)).
by case: eqP => [->|_]; rewrite ?muln0 ?addn0.
Qed.

(* a class of covers: c tells apart no two walks that end on the path and have not left it *)
Section Voltage.
Variable c : W -> bool.
Hypothesis c_sym : forall d, c (alpha d) = c d.

Fixpoint sheets_entered w d b (out : bool) :=
  if w is k :: w' then
    let d' := motion k d in
    let b' := b (+) c (iter k sigma d) in
    let out' := out || (level d' == L) in
    if at_same_vertex v0 d' then
      if out' then b' :: sheets_entered w' d' b' (L == 0) else sheets_entered w' d' b' (L == 0)
    else sheets_entered w' d' b' out'
  else [::].

Lemma size_sheets w d b out : size (sheets_entered w d b out) = returns w d out.
Proof.
elim: w d b out => //= k w IH d b out; case: ifP => _; rewrite ?IH //.
by case: (out || _); rewrite /= IH.
Qed.

Fixpoint potential l := if l is l'.+1 then potential l' (+) c (up l') else false.

Lemma potential_step d : level d < L -> level (alpha d) < L ->
  c d = potential (level d) (+) potential (level (alpha d)).
Proof.
move=> l1 l2; case: (level_path P l1) => -[E U].
  by rewrite E /= -U addbA addbb.
by rewrite -E /= -U c_sym addbC addbA addbb.
Qed.

Lemma sheets_quiet w d b (out : bool) : (level d == L -> out) ->
  (~~ out -> b = potential (level d)) -> all negb (sheets_entered w d b out) ->
  quiet c w d b.
Proof.
elim: w d b out => //= k w IH d b out far po.
set d' := motion k d; set b' := b (+) _; set out' := out || _.
have po' : ~~ out' -> b' = potential (level d').
  rewrite negb_or => /andP[no nL]; rewrite /b' po //.
  have lt x : level x != L -> level x < L by rewrite ltn_neqAle (level_max P) andbT.
  have nd : level d != L by apply: contra no.
  rewrite -(level_turn k d) in nd *; rewrite (potential_step (lt _ nd)) ?lt //.
  by rewrite addbA addbb.
case: ifP => [at0|_ H]; last by rewrite (IH d' b' out') // => e; rewrite /out' e orbT.
have l0 := level_v0 at0 => H.
have [nb H'] : ~~ b' /\ all negb (sheets_entered w d' b' (L == 0)).
  move: H; case E: out'; first by case/andP.
  by move=> ->; rewrite po' ?E // l0.
rewrite nb (IH d' b' (L == 0)) //; first by rewrite l0 eq_sym.
by rewrite l0 (negbTE nb).
Qed.
End Voltage.

Lemma sheets_xor c c' w d b b' out :
  sheets_entered (fun x => c x (+) c' x) w d (b (+) b') out =
  [seq p.1 (+) p.2 | p <- zip (sheets_entered c w d b out) (sheets_entered c' w d b' out)].
Proof.
elim: w d b b' out => //= k w IH d b b' out.
have -> : b (+) b' (+) (c (iter k sigma d) (+) c' (iter k sigma d)) =
  b (+) c (iter k sigma d) (+) (b' (+) c' (iter k sigma d)) by rewrite addbACA.
by rewrite !IH; case: ifP => // _; case: ifP.
Qed.
End Excursions.

(* ---- Each cycle of the map costs a return to v0 ---- *)
Section Returns.
Variables (E : Type) (meaning : E -> rooted_map) (X : explorer percept E).
Hypothesis right_X : right_everywhere meaning X.
Variables (W : lighthouse_world) (L : nat) (level : W -> nat) (up : nat -> W).
Hypothesis P : path_from_start L level up.
Local Notation v0 := (@start W).
Variables (fuel : nat) (t : seq (nat * percept)) (e : E) (z : W).
Hypothesis stopped : episode X (rooted v0) (@percept_of W) fuel = (t, Some e, z).
Local Notation w := (unzip1 t).
Local Notation outer := (returns L level w v0 (L == 0)).

Let edge_set : {set W} := [set r in froots (@alpha W)].
Let vertex_set : {set W} := [set r in froots (@sigma W)] :\ froot sigma v0.
Let chosen (A : {set W}) d := froot alpha d \in A.
Let cut (B : {set W}) d := (froot sigma d \in B) (+) (froot sigma (alpha d) \in B).

Lemma sheets_tuple c : size (sheets_entered L level c w v0 false (L == 0)) == outer.
Proof. by rewrite size_sheets. Qed.

Let sheets c : outer.-tuple bool := Tuple (sheets_tuple c).

Lemma chosen_sym A d : chosen A (alpha d) = chosen A d.
Proof.
rewrite /chosen; have /(rootP (fconnect_sym (@alpha_inj W))) -> // : fconnect alpha (alpha d) d.
by rewrite (fconnect_sym (@alpha_inj W)) fconnect1.
Qed.

(* two sets of edges that the walk does not tell apart differ by a cut *)
Lemma indistinct_cut A A' : sheets (chosen A) = sheets (chosen A') ->
  exists2 B : {set W}, B \subset vertex_set & forall d, chosen A d (+) chosen A' d = cut B d.
Proof.
move/(congr1 val) => /= S; pose c d := chosen A d (+) chosen A' d.
have c_sym d : c (alpha d) = c d by rewrite /c !chosen_sym.
have Q : quiet c w v0 false.
  apply: (sheets_quiet P c_sym (out := L == 0)); rewrite ?(level_start P) ?(eq_sym 0) //.
  have -> : sheets_entered L level c w v0 false (L == 0) =
      sheets_entered L level c w v0 (false (+) false) (L == 0) by [].
  rewrite sheets_xor S; elim: (sheets_entered _ _ _ _ _ _ _) => //= b l ->.
  by rewrite addbb.
case: (boolP (connect (adjacent (@voltage_sigma W) (voltage_alpha c)) (v0, false) (v0, true))) =>
  [R|N].
  have A0 := quiet_agrees c_sym R (episode_agrees stopped) Q.
  have := right_explorer_determines (right_X W) (right_X (voltage_world c_sym R)) stopped A0.
  by move/voltage_not_isomorphic.
have [nv H] := disconnected_potential c_sym N; exists (upper c) => //.
apply/subsetP=> r rB; rewrite !inE; apply/andP; split; last by move: rB; rewrite inE => /andP[].
by apply: contra nv => /eqP <-.
Qed.

Lemma card_edge_set : #|edge_set| = edges W.
Proof. by rewrite cardsE /edges /n_comp_mem; apply: eq_card => r; rewrite !inE andbT. Qed.

Lemma card_vertex_set : (#|vertex_set|).+1 = vertices W.
Proof.
have r0 : froot sigma v0 \in [set r in froots (@sigma W)].
  by rewrite inE; exact: (roots_root (fconnect_sym (@sigma_inj W))).
have := cardsD1 (froot sigma v0) [set r in froots (@sigma W)]; rewrite r0 add1n => <-.
by rewrite cardsE /vertices /n_comp_mem; apply: eq_card => r; rewrite !inE andbT.
Qed.

Theorem returns_at_least : edges W + 1 <= vertices W + outer.
Proof.
pose same_sheets (v : outer.-tuple bool) (A : {set W}) := sheets (chosen A) == v.
pose first_of v : {set W} := odflt set0 [pick A in powerset edge_set | same_sheets v A].
pose difference A (B : {set W}) := [forall d, chosen A d (+) chosen (first_of (sheets (chosen A)))
  d == cut B d].
pose cut_of A : {set W} := odflt set0 [pick B in powerset vertex_set | difference A B].
have firstP A : A \in powerset edge_set -> sheets (chosen (first_of (sheets (chosen A)))) =
  sheets (chosen A).
  move=> EA; rewrite {1}/first_of; case: pickP => [A' /andP[_ /eqP] //|/(_ A)].
  by rewrite EA /same_sheets eqxx.
have cutP A : A \in powerset edge_set ->
    cut_of A \in powerset vertex_set /\
    forall d, chosen A d (+) chosen (first_of (sheets (chosen A))) d = cut (cut_of A) d.
  move=> EA; rewrite /cut_of; case: pickP => [B /andP[EB /forallP H]|N].
    by split=> // d; apply/eqP.
  have [B EB H] := indistinct_cut (esym (firstP A EA)).
  have /negP[] := negbT (N B); rewrite powersetE EB /=; apply/forallP=> d; by rewrite H.
have inj : {in powerset edge_set &, injective (fun A => (sheets (chosen A), cut_of A))}.
  move=> A A' EA EA' [] S C; have S' : sheets (chosen A) = sheets (chosen A') by apply: val_inj.
  have [_ H] := cutP A EA; have [_ H'] := cutP A' EA'.
  have same_c d : chosen A d = chosen A' d.
    by apply: (@addIb (chosen (first_of (sheets (chosen A))) d)); rewrite H C S' -H'.
  apply/setP=> r; move: EA EA'; rewrite !powersetE => /subsetP EA /subsetP EA'.
  have root r' : r' \in edge_set -> froot alpha r' = r' by rewrite inE => /eqP.
  by apply/idP/idP=> m; have := same_c r; rewrite /chosen root ?m; auto; move=> ->.
have := card_in_imset inj; set I := imset _ _ => cI.
have: #|I| <= #|setX [set: outer.-tuple bool] (powerset vertex_set)|.
  apply: subset_leq_card; apply/subsetP=> x /imsetP[A EA ->]; rewrite inE /= inE /=.
  by have [] := cutP A EA.
rewrite cI cardsX cardsT card_tuple card_bool !card_powerset card_edge_set -expnD leq_exp2l //.
by rewrite addn1 -card_vertex_set addSn ltnS addnC.
Qed.

Corollary far_cycles_cost : 2 * L * (edges W + 1 - vertices W) <= size t.
Proof.
apply: (leq_trans _ (leq_trans (returns_cost_start P w) _)); last by rewrite size_map.
by rewrite leq_mul2l leq_subLR returns_at_least orbT.
Qed.
End Returns.

(* ---- Entries into v0 ---- *)
Section Entries.
Variables (E : Type) (meaning : E -> rooted_map) (X : explorer percept E).
Hypothesis right_X : right_everywhere meaning X.
Variable W : lighthouse_world.
Local Notation v0 := (@start W).

Fixpoint entries w (d : W) :=
  if w is k :: w' then at_same_vertex v0 (motion k d) + entries w' (motion k d) else 0.

Theorem entries_at_least fuel t e z :
  episode X (rooted v0) (@percept_of W) fuel = (t, Some e, z) ->
  edges W + 1 <= vertices W + entries (unzip1 t) v0.
Proof.
move=> R; have P : path_from_start 0 (fun _ : W => 0) (fun _ => v0) by [].
have -> : entries (unzip1 t) v0 = returns 0 (fun=> 0) (unzip1 t) v0 true.
  by elim: (unzip1 t) v0 => //= k w IH d; rewrite IH; case: ifP.
exact: (returns_at_least right_X P R).
Qed.
End Entries.

(* ---- Any world at the end of a path ---- *)
Section OneLonger.
Variable W : lighthouse_world.
Local Notation v0 := (@start W).

(* two more darts: inr false at the new v0, inr true next to the dart that was faced at the old v0 *)
Definition longer_sigma (x : W + bool) : W + bool :=
  match x with
  | inl d => if d == v0 then inr true else inl (sigma d)
  | inr b => if b then inl (sigma v0) else inr false
  end.
Definition longer_alpha (x : W + bool) : W + bool :=
  match x with inl d => inl (alpha d) | inr b => inr (~~ b) end.

Lemma longer_sigma_inj : injective longer_sigma.
Proof.
move=> [x|[]] [y|[]] //=.
- by case: (x =P v0) => [->|_]; case: (y =P v0) => [->|_] // [/sigma_inj ->].
- by case: (x =P v0) => [->|ne] // [/sigma_inj /ne].
- by case: (x =P v0).
- by case: (y =P v0) => [->|ne] // [/sigma_inj /esym /ne].
by case: (y =P v0).
Qed.

Lemma longer_alphaK : involutive longer_alpha.
Proof. by move=> [x|[]] //=; rewrite alphaK. Qed.

Lemma longer_alpha_neq x : longer_alpha x != x.
Proof. by case: x => [x|[]] //=; have := alpha_neq x; apply: contra => /eqP[->]. Qed.

Lemma longer_connected x y : connect (adjacent longer_sigma longer_alpha) x y.
Proof.
set adj := adjacent _ _.
have cs u : connect adj u (longer_sigma u) by apply: connect1; rewrite /adj /adjacent eqxx.
have ca u : connect adj u (longer_alpha u) by apply: connect1; rewrite /adj /adjacent eqxx orbT.
have first : connect adj (inr false) (inl v0).
  apply: connect_trans (ca (inr false)) _;
    rewrite /adj (adjacent_connect_sym longer_sigma_inj longer_alphaK).
  by have := cs (inl v0); rewrite /= eqxx.
have H u : connect adj (inr false) u.
  case: u => [d|[]]; [|exact: ca (inr false)|exact: connect0].
  move: d; apply: (everywhere first) => d R; last exact: connect_trans R (ca (inl d)).
  case: (d =P v0) => [->|/eqP ne]; first exact: connect_trans (ca (inr false)) (cs (inr true)).
  by apply: connect_trans R _; have := cs (inl d); rewrite /= (negbTE ne).
apply: connect_trans (H y); by rewrite /adj (adjacent_connect_sym longer_sigma_inj longer_alphaK).
Qed.

Definition longer_map :=
  CombinatorialMap longer_sigma_inj longer_alphaK longer_alpha_neq longer_connected.
Definition longer := @LighthouseWorld longer_map (inr false) (inr false) (connect0 _ _).

Lemma edges_longer : edges longer = (edges W).+1.
Proof. by apply: double_inj; rewrite edges_double card_sum card_bool doubleS edges_double addn2.
  Qed.

(* the vertices of W remain, and inr true comes to the old v0 *)
Lemma longer_same (d d' : W) : fconnect sigma d d' -> fconnect (@sigma longer) (inl d) (inl d').
Proof.
move/iter_findex <-; elim: (findex _ _ _) => //= k IH; apply: connect_trans IH _.
move: (iter k sigma d) => u; case: (u =P v0) => [->|/eqP ne].
  rewrite (_ : inl (sigma v0) = iter 2 (@sigma longer) (inl v0)) ?fconnect_iter //=.
  by rewrite eqxx.
by rewrite (_ : inl (sigma u) = @sigma longer (inl u)) ?fconnect1 //= (negbTE ne).
Qed.

Lemma longer_joined : fconnect (@sigma longer) (inl v0) (inr true).
Proof. by rewrite (_ : inr true = @sigma longer (inl v0)) ?fconnect1 //= eqxx. Qed.

Lemma vertices_longer : vertices longer = (vertices W).+1.
Proof.
pose vertex_of (x : longer) : option W :=
  match x with
  | inl d => Some (froot sigma d)
  | inr b => if b then Some (froot sigma v0) else None
  end.
have step (d : W) : froot sigma (sigma d) = froot sigma d.
  apply/eqP; rewrite (root_connect (fconnect_sym (@sigma_inj W))) (fconnect_sym (@sigma_inj W)).
  exact: fconnect1.
have inv (x : longer) : vertex_of (sigma x) = vertex_of x.
  by case: x => [d|[]] //=; rewrite ?step //; case: eqP => [->|_] //=; rewrite step.
have inv_root (x : longer) : vertex_of (froot sigma x) = vertex_of x.
  rewrite -(iter_findex (connect_root _ x)).
  by elim: (findex _ _ _) => // k IH; rewrite iterS inv.
have sym := fconnect_sym (@sigma_inj longer).
have symW (d d' : W) : froot sigma d = froot sigma d' -> fconnect sigma d d'.
  by move/eqP; rewrite (root_connect (fconnect_sym (@sigma_inj W))).
have sep (x y : longer) : vertex_of x = vertex_of y -> fconnect sigma x y.
  case: x y => [d|b] [d'|b'] /=.
  - by case=> /symW /longer_same.
  - case: b' => // E; apply: connect_trans longer_joined; apply: longer_same; apply: symW.
    by case: E.
  - case: b => // E; rewrite sym; apply: connect_trans longer_joined; apply: longer_same; apply: symW.
    by case: E.
  by case: b b' => [] [].
pose roots_of (G : combinatorial_map) : {set G} := [set r in froots (@sigma G)].
have card_roots (G : combinatorial_map) : vertices G = #|roots_of G|.
  by rewrite cardsE /vertices /n_comp_mem; apply: eq_card => r; rewrite !inE andbT.
have inj : {in roots_of longer &, injective vertex_of}.
  move=> x y; rewrite !inE => /eqP rx /eqP ry /sep.
  by rewrite -(root_connect sym) rx ry => /eqP.
rewrite (card_roots longer) -(card_in_imset inj) (card_roots W).
have -> : vertex_of @: roots_of longer = None |: Some @: roots_of W.
  apply/setP=> x; rewrite in_setU1; apply/imsetP/orP=> [[y ry ->]|].
    case: y ry => [d|[]] ry /=; [right | right | by left].
      by apply: imset_f; rewrite inE; exact: (roots_root (fconnect_sym (@sigma_inj W))).
    by apply: imset_f; rewrite inE; exact: (roots_root (fconnect_sym (@sigma_inj W))).
  case=> [/eqP->|/imsetP[r rr ->]].
    exists (froot sigma (inr false : longer)); last by rewrite inv_root.
    by rewrite inE; exact: (roots_root sym).
  exists (froot sigma (inl r : longer)); first by rewrite inE; exact: (roots_root sym).
  by rewrite inv_root /=; move: rr; rewrite inE => /eqP->.
rewrite cardsU1 card_imset; last by move=> u v [].
by have -> : None \notin Some @: roots_of W by apply/imsetP=> -[].
Qed.

Lemma longer_path L level up : @path_from_start W L level up ->
  @path_from_start longer L.+1
    (fun x => match x with inl d => (level d).+1 | inr b => b : nat end)
    (fun j => if j is j'.+1 then inl (up j') else inr false).
Proof.
move=> P; have l0 := level_start P; split=> //.
- by case=> [d|[]] /=; [case: eqP => [->|_] /=; rewrite ?(level_sigma P) ?l0
  | rewrite (level_sigma P) l0 |].
- by case=> [d|[]] //=; rewrite ltnS; exact: (level_max P).
- by case=> [d|[]] //=; rewrite ltnS; exact: (level_step P).
case=> [d|[]] /=; [|by right|by left].
rewrite ltnS => /(level_path P) [[E U]|[E U]]; [left | right]; split; rewrite ?E //; congr inl.
  exact: U.
exact: U.
Qed.
End OneLonger.

Fixpoint at_end_of_path L W := if L is L'.+1 then longer (at_end_of_path L' W) else W.

Lemma at_end_path L W : exists level up, @path_from_start (at_end_of_path L W) L level up.
Proof.
elim: L => [|L [level [up P]]]; first by exists (fun=> 0), (fun=> start).
by do 2 eexists; exact: longer_path P.
Qed.

Lemma at_end_edges L W : edges (at_end_of_path L W) = L + edges W.
Proof. by elim: L => //= L IH; rewrite edges_longer IH. Qed.

Lemma at_end_vertices L W : vertices (at_end_of_path L W) = L + vertices W.
Proof. by elim: L => //= L IH; rewrite vertices_longer IH. Qed.

(* one vertex with k+1 loops *)
Section Bouquet.
Variable k : nat.

Definition bouquet_sigma (i : 'I_(k.*2.+2)) : 'I_(k.*2.+2) := inord (i.+1 %% k.*2.+2).

Lemma bouquet_val i : val (bouquet_sigma i) = i.+1 %% k.*2.+2.
Proof. by rewrite /= inordK // ltn_pmod. Qed.

Lemma bouquet_turn j i : val (iter j bouquet_sigma i) = (i + j) %% k.*2.+2.
Proof.
elim: j => [|j IH]; first by rewrite addn0 modn_small.
by rewrite iterS bouquet_val IH -addn1 modnDml addn1 addnS.
Qed.

Lemma bouquet_full i : iter k.*2.+2 bouquet_sigma i = i.
Proof. by apply: val_inj; rewrite bouquet_turn modnDr modn_small. Qed.

Lemma bouquet_sigma_inj : injective bouquet_sigma.
Proof. by move=> i j E; rewrite -(bouquet_full i) -(bouquet_full j) !iterSr E. Qed.

Lemma bouquet_all i j : fconnect bouquet_sigma i j.
Proof.
have -> : j = iter (k.*2.+2 - i + j) bouquet_sigma i.
  by apply: val_inj; rewrite bouquet_turn addnA subnKC ?(ltnW (ltn_ord i)) // modnDl modn_small.
exact: fconnect_iter.
Qed.

Lemma bouquet_alpha_neq (i : 'I_(k.*2.+2)) : rev_ord i != i.
Proof.
apply/eqP=> /(congr1 val) /= E; move: (ltn_ord i) E; move: (nat_of_ord i) => j lj E.
have : k.+1.*2 = j + j.+1 by rewrite doubleS -(subnK lj) E.
by move/(congr1 odd); rewrite odd_double addnS /= addnn odd_double.
Qed.

Lemma bouquet_connected i j : connect (adjacent bouquet_sigma (@rev_ord _)) i j.
Proof.
apply: connect_sub (bouquet_all i j) => a b /eqP <-.
by apply: connect1; rewrite /adjacent eqxx.
Qed.

Definition bouquet_map :=
  CombinatorialMap bouquet_sigma_inj (@rev_ordK _) bouquet_alpha_neq bouquet_connected.
Definition bouquet := @LighthouseWorld bouquet_map ord0 ord0 (connect0 _ _).

Lemma edges_bouquet : edges bouquet = k.+1.
Proof. by apply: double_inj; rewrite edges_double card_ord. Qed.

Lemma vertices_bouquet : vertices bouquet = 1.
Proof.
rewrite /vertices /n_comp_mem (@eq_card _ _ (pred1 (froot (@sigma bouquet) ord0))) ?card1 //.
have sym := fconnect_sym (@sigma_inj bouquet).
move=> r; rewrite !inE andbT; apply/eqP/eqP=> [<-|->]; last first.
  by apply/eqP; rewrite (root_connect sym); exact: bouquet_all.
by apply/eqP; rewrite (root_connect sym); exact: bouquet_all.
Qed.
End Bouquet.

Theorem path_costs_every_cycle (E : Type) (meaning : E -> rooted_map) (X : explorer percept E) :
  right_everywhere meaning X -> forall W L fuel t e z,
  episode X (rooted (@start (at_end_of_path L W))) (@percept_of _) fuel = (t, Some e, z) ->
  2 * L * (edges W + 1 - vertices W) <= size t.
Proof.
move=> H W L fuel t e z R; have [level [up P]] := at_end_path L W.
have := far_cycles_cost H P R; rewrite at_end_edges at_end_vertices -addnA subnDl.
by [].
Qed.

(* k+1 loops at the end of a path of length k+1: m = 2(k+1), n = k+2 *)
Corollary mn_lower_bound (E : Type) (meaning : E -> rooted_map) (X : explorer percept E) :
  right_everywhere meaning X -> forall k, exists W : lighthouse_world,
  [/\ edges W = k.+1.*2, vertices W = k.+2 & forall fuel t e z,
      episode X (rooted (@start W)) (@percept_of W) fuel = (t, Some e, z) ->
      edges W * (vertices W - 1) <= size t].
Proof.
move=> H k; exists (at_end_of_path k.+1 (bouquet k)).
rewrite at_end_edges at_end_vertices edges_bouquet vertices_bouquet addnn addn1; split=>
  // fuel t e z R.
have := path_costs_every_cycle H R; rewrite edges_bouquet vertices_bouquet addn1 subn1 /= mul2n.
by [].
Qed.

(* ---- The hypothesis can be met: Algorithm 1 is such an explorer, under every policy ---- *)
Theorem algorithm1_right_everywhere pol : right_everywhere denote (algorithm1 pol).
Proof. by move=> W; exact: algorithm1_right. Qed.

Corollary algorithm1_log_folds pol (W : lighthouse_world) fuel t e z :
  episode (algorithm1 pol) (rooted (@start W)) (@percept_of W) fuel = (t, Some e, z) ->
  no_open_dart (log_of W t).
Proof. exact: (right_explorer_log_folds (algorithm1_right_everywhere pol)). Qed.
