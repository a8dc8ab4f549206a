(* ---------------------------------------------------------------------------------------------
   Lower bounds for every explorer that is right in all worlds with a lighthouse.      Section VI

   n, m: the numbers of vertices and edges of the world that it is in.  There are 2^m colourings of the
   edges (TwoSheets.v), 2^(n-1) of them separate vertices, and k returns to v0 tell apart 2^k at most: so
   m <= k+n-1.

     edges_at_most_motions   at least m motions.
     entries              all entries into v0.
     returns_at_least     at least m-n+1 returns from beyond the path.
     entries_at_least     at least m-n+1 entries into v0.
     far_cycles_cost      at least 2 L (m-n+1) motions where v0 is at the end of a path of L edges.
     path_costs_every_cycle  the same for any world W put at the end of such a path, m and n of W.
     mn_lower_bound       a world with m = 2(k+1) and n = k+2, for every k, which needs m (n-1) motions,
                          the same for all explorers.
     mn_lower_bound_simple   a simple world with n = 2q and m = q(q+1)/2, for every q >= 7, which needs
                          mn/2 motions, the same for all explorers that find the maps of simple worlds.
     algorithm1_finds_all_maps, algorithm1_log_folds   Algorithm 1 is such an explorer, so its log
                          leaves no dart open.
   --------------------------------------------------------------------------------------------- *)
From mathcomp Require Import all_ssreflect.
From Coq Require Import Lia.
From Allworlds Require Import Model Maps Percepts RootedMaps Explorers Algorithm Refinement Congruence.
From Allworlds Require Import Log Folding OpenDarts TwoSheets Excursions PathWorlds.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(* ---- At least m motions ---- *)
Section AtLeastOneMotionAnEdge.
Variables (E : Type) (meaning : E -> rooted_map) (X : explorer percept E).
Variable u : universe.
Hypothesis finds_maps : finds_all_maps u meaning X.

Theorem edges_at_most_motions (W : lighthouse_world) fuel t e z : in_universe u W ->
  episode X (rooted (@start W)) (@percept_of W) fuel = (t, Some e, z) -> edges W <= size t.
Proof.
move=> U R; have A := episode_agrees R; have nopen := explorer_log_folds finds_maps U R.
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

(* ---- Each cycle of the map costs a return to v0 ---- *)
Section Returns.
Variables (E : Type) (meaning : E -> rooted_map) (X : explorer percept E).
Variable u : universe.
Hypothesis finds_maps : finds_all_maps u meaning X.
Variables (W : lighthouse_world) (L : nat) (level : W -> nat) (up : nat -> W).
Hypothesis in_u : in_universe u W.
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
  have := one_log_one_map (finds_maps in_u) (finds_maps (voltage_in_universe c_sym R in_u)) stopped
    (episode_agrees stopped) A0.
  by move/voltage_not_same_map.
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
Variable u : universe.
Hypothesis finds_maps : finds_all_maps u meaning X.
Variable W : lighthouse_world.
Hypothesis in_u : in_universe u W.
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
exact: (returns_at_least finds_maps in_u P R).
Qed.
End Entries.

(* ---- Worlds that are costly for every explorer ---- *)
Theorem path_costs_every_cycle u (E : Type) (meaning : E -> rooted_map) (X : explorer percept E) :
  finds_all_maps u meaning X -> forall W L fuel t e z, in_universe u W ->
  episode X (rooted (@start (at_end_of_path L W))) (@percept_of _) fuel = (t, Some e, z) ->
  2 * L * (edges W + 1 - vertices W) <= size t.
Proof.
move=> F W L fuel t e z U R; have [level [up P]] := at_end_path L W.
have := far_cycles_cost F (at_end_in_universe L U) P R.
by rewrite at_end_edges at_end_vertices -addnA subnDl.
Qed.

(* k+1 loops at the end of a path of length k+1: m = 2(k+1), n = k+2; one world for all explorers *)
Corollary mn_lower_bound k : exists W : lighthouse_world, [/\ edges W = k.+1.*2, vertices W = k.+2 &
  forall (E : Type) (meaning : E -> rooted_map) (X : explorer percept E),
  finds_all_maps AllWorlds meaning X -> forall fuel t e z,
  episode X (rooted (@start W)) (@percept_of W) fuel = (t, Some e, z) ->
  edges W * (vertices W - 1) <= size t].
Proof.
exists (at_end_of_path k.+1 (bouquet k)).
rewrite at_end_edges at_end_vertices edges_bouquet vertices_bouquet addnn addn1; split=> //.
move=> E meaning X F fuel t e z R.
by have := path_costs_every_cycle F I R; rewrite edges_bouquet vertices_bouquet addn1 subn1 /= mul2n.
Qed.

(* the complete graph with q vertices at the end of a path of length q: a simple world with n = 2q and
   m = q(q+1)/2 *)
Theorem complete_lower_bound k : let q := k.+3 in exists W : lighthouse_world,
  [/\ simple_world W, edges W = 'C(q.+1, 2), vertices W = q.*2 &
  forall (E : Type) (meaning : E -> rooted_map) (X : explorer percept E),
  finds_all_maps SimpleWorlds meaning X -> forall fuel t e z,
  episode X (rooted (@start W)) (@percept_of W) fuel = (t, Some e, z) ->
  q * (q - 1) * (q - 2) <= size t].
Proof.
move=> q; exists (at_end_of_path q (complete k)).
have S : in_universe SimpleWorlds (complete k) by exact: complete_simple.
have m : q + 'C(q, 2) = 'C(q.+1, 2) by rewrite binS bin1 addnC.
rewrite at_end_edges at_end_vertices edges_complete vertices_complete addnn m.
split=> //; first exact: (at_end_in_universe (u := SimpleWorlds) q S).
move=> E meaning X F fuel t e z R; have := path_costs_every_cycle F S R.
rewrite edges_complete vertices_complete; apply: leq_trans.
have := mul_bin_diag q 1; rewrite bin1 /q; move: 'C(_, 2) => B B2; apply/leP.
by move: B2; rewrite -!(plusE, multE, minusE); nia.
Qed.

Corollary mn_lower_bound_simple q : 7 <= q -> exists W : lighthouse_world,
  [/\ simple_world W, edges W = 'C(q.+1, 2), vertices W = q.*2 &
  forall (E : Type) (meaning : E -> rooted_map) (X : explorer percept E),
  finds_all_maps SimpleWorlds meaning X -> forall fuel t e z,
  episode X (rooted (@start W)) (@percept_of W) fuel = (t, Some e, z) ->
  edges W * vertices W <= 2 * size t].
Proof.
case: q => [|[|[|k]]] // q7; have [W [S m n H]] := complete_lower_bound k.
exists W; split=> // E meaning X F fuel t e z R; have := H _ _ _ F _ _ _ _ R.
have := mul_bin_diag k.+4 1; rewrite m n bin1 -muln2; move: 'C(_, 2) (size t) q7 => B s /leP + B2 /leP.
by move=> q7 le; apply/leP; move: q7 B2 le; rewrite -!(plusE, multE, minusE) /=; nia.
Qed.

(* ---- The hypothesis can be met: Algorithm 1 is such an explorer, under every policy ---- *)
Theorem algorithm1_finds_all_maps pol u : finds_all_maps u denote (algorithm1 pol).
Proof. by move=> W _; apply: right_finds_map; exact: algorithm1_right. Qed.

Corollary algorithm1_log_folds pol (W : lighthouse_world) fuel t e z :
  episode (algorithm1 pol) (rooted (@start W)) (@percept_of W) fuel = (t, Some e, z) ->
  no_open_dart (log_of W t).
Proof. exact: (explorer_log_folds (algorithm1_finds_all_maps pol (u := AllWorlds)) I). Qed.
