(* ---------------------------------------------------------------------------------------------
   The same world under other names; and what is computed of a world that is written down.

     renaming f           f is a bijection of the darts that commutes with sigma and alpha.
     same_world f         besides it takes start to start and pointed to pointed.  For such an f:
     same_degree, same_percept, same_vertices, same_edges, same_simple, same_planar
                          what it keeps.

     cycles_fcard         Twins.cycles counts cycles.
     vertices_in M, edges_in M        of a numbered map, computed.
     vertices_in_numbers, edges_in_numbers, planar_in_numbers, simple_in_numbers   what is computed is so.
     written_down         every world is, under other names, one of rooted_maps (edges W) with the
                          marker along one of the darts at its root.
   --------------------------------------------------------------------------------------------- *)
From mathcomp Require Import all_ssreflect.
From Allworlds Require Import Model Maps Percepts RootedMaps Codes Explorers Indistinguishable.
From Allworlds Require Import NumberedWorlds Twins Enumeration Cluster.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(* ---- Counting cycles ---- *)

(* any choice of one member in each cycle counts the cycles *)
Lemma fcard_chosen (T : finType) (f : T -> T) (chosen : T -> T) : injective f ->
  (forall x, fconnect f x (chosen x)) -> (forall x y, fconnect f x y -> chosen x = chosen y) ->
  fcard f T = #|[pred x | chosen x == x]|.
Proof.
move=> fi in_cycle of_cycle; have sym := fconnect_sym fi.
have chosen_root x : chosen (froot f x) = chosen x by apply/esym/of_cycle/connect_root.
have root_chosen x : froot f (chosen x) = froot f x by apply/esym/(rootP sym); exact: in_cycle.
rewrite -(card_in_image (f := froot f) (A := [pred x | chosen x == x])); last first.
  by move=> x y /eqP <- /eqP <-; rewrite !root_chosen => /(congr1 chosen); rewrite !chosen_root.
apply: eq_card => x; rewrite !inE andbT; apply/idP/imageP=> [/eqP r|[y _ ->]]; last first.
  exact: roots_root.
exists (chosen x); last by rewrite root_chosen.
by rewrite inE; apply/eqP/esym/of_cycle/in_cycle.
Qed.

Section CyclesInNumbers.
Variables (n : nat) (F : 'I_n -> 'I_n) (f : nat -> nat).
Hypotheses (F_inj : injective F) (FE : forall i, val (F i) = f (val i)).

Lemma iter_in_numbers k i : val (iter k F i) = iter k f (val i).
Proof. by elim: k => //= k <-; exact: FE. Qed.

Lemma least_small (i : 'I_n) : least f i n < n.
Proof.
rewrite /least; elim: (iota 0 n) => //= k l IH; rewrite -iter_in_numbers gtn_min.
by rewrite ltn_ord.
Qed.

Definition least_of i : 'I_n := Ordinal (least_small i).

Lemma least_le d k : k < n -> least f d n <= iter k f d.
Proof.
rewrite /least => kn; have: k \in iota 0 n by rewrite mem_iota.
elim: (iota 0 n) => //= j l IH; rewrite inE geq_min => /orP[/eqP->|/IH->]; rewrite ?leqnn //.
by rewrite orbT.
Qed.

Lemma least_mem d : 0 < n -> exists2 k, k < n & least f d n = iter k f d.
Proof.
move=> n0; suff H l : all (fun k => k < n) l ->
    exists2 k, k < n & foldr minn d [seq iter k f d | k <- l] = iter k f d.
  by apply: H; apply/allP=> k; rewrite mem_iota.
elim: l => [_|j l IH] /=; first by exists 0.
case/andP=> ln /IH[k kn ->]; rewrite /minn; case: ifP => _; [by exists j | by exists k].
Qed.

Lemma least_in_cycle i : fconnect F i (least_of i).
Proof.
have [k _ E] := least_mem (val i) (leq_ltn_trans (leq0n _) (ltn_ord i)).
have -> : least_of i = iter k F i by apply: val_inj; rewrite /= E iter_in_numbers.
exact: fconnect_iter.
Qed.

Lemma least_of_cycle i j : fconnect F i j -> least_of i = least_of j.
Proof.
have le x y : fconnect F x y -> least_of x <= least_of y.
  move=> c; have := connect_trans c (least_in_cycle y) => c'.
  rewrite -(iter_findex c') iter_in_numbers; apply: least_le.
  apply: leq_trans (findex_max c') _; rewrite -[X in _ <= X](card_ord n); exact: max_card.
move=> c; apply/val_inj/eqP; rewrite eqn_leq (le i j c) le //.
by rewrite (fconnect_sym F_inj).
Qed.

Theorem cycles_fcard : fcard F 'I_n = cycles f n.
Proof.
rewrite (fcard_chosen F_inj least_in_cycle least_of_cycle) /cycles -sum1_count.
have -> : iota 0 n = index_iota 0 n by rewrite /index_iota subn0.
by rewrite big_mkord -sum1_card; exact: eq_bigl.
Qed.
End CyclesInNumbers.

(* ---- Sizes, and kinds of maps, in numbers ---- *)
Definition vertices_in M := cycles (nth 0 (sigma_list M)) (size (sigma_list M)).
Definition edges_in M := (size (sigma_list M))./2.

Definition faces (G : combinatorial_map) := fcard (fun d : G => sigma (alpha d)) G.
Definition planar_map (G : combinatorial_map) := vertices G + faces G = edges G + 2.

Section InNumbers.
Variable M : numbered_map.
Hypotheses (V : valid M) (C : connected (denote M)).
Local Notation G := (in_numbers V C).
Local Notation n := (size (sigma_list M)).

Theorem vertices_in_numbers : vertices G = vertices_in M.
Proof. exact: (@cycles_fcard _ (@sigma G)) (@sigma_inj G) _. Qed.

Theorem edges_in_numbers : edges G = edges_in M.
Proof. by rewrite /edges_in -[n in n./2](card_ord n) -[LHS]doubleK (edges_double G). Qed.

Lemma alpha_cycles : cycles (nth 0 (alpha_list M)) n = edges G.
Proof. by apply/esym; exact: (@cycles_fcard _ (@alpha G)) (@alpha_inj G) _. Qed.

Theorem planar_in_numbers : reflect (planar_map G) (planar M).
Proof.
have fi : injective (fun d : G => sigma (alpha d)) by move=> x y /sigma_inj /alpha_inj.
have F : faces G = cycles (nth 0 (sigma_list M) \o nth 0 (alpha_list M)) n.
  exact: (@cycles_fcard _ _ _ fi).
by rewrite /planar alpha_cycles -F -/(vertices_in M) -vertices_in_numbers; exact: eqP.
Qed.

Theorem simple_in_numbers : reflect (simple_world G) (simple M).
Proof.
pose vertex d := least (nth 0 (sigma_list M)) d n.
have lv (i j : G) : (vertex (val i) == vertex (val j)) = at_same_vertex i j.
  have FE (k : G) : val (sigma k) = nth 0 (sigma_list M) (val k) by [].
  apply/eqP/idP=> [E|/(least_of_cycle (@sigma_inj G) FE) /(congr1 val) //].
  have c k := least_in_cycle FE (k : 'I_n).
  have e : least_of FE i = least_of FE j by exact: val_inj.
  have := c i; rewrite e => ci; apply: connect_trans ci _.
  by rewrite (fconnect_sym (@sigma_inj G)); exact: c.
pose ends i := (vertex i, vertex (nth 0 (alpha_list M) i)).
have endsE (i j : G) : (ends (val i) == ends (val j)) =
    at_same_vertex i j && at_same_vertex (alpha i) (alpha j).
  by rewrite xpair_eqE lv -[nth 0 _ i]/(val (alpha i)) -[nth 0 _ j]/(val (alpha j)) lv.
rewrite /simple -/vertex -[[seq _ | d <- _]]/(mkseq ends n).
apply: (iffP andP) => [[/mkseq_uniqP U _] i j s t|S].
  by apply/val_inj/U; rewrite ?inE ?ltn_ord //; apply/eqP; rewrite endsE s t.
split.
  apply/mkseq_uniqP=> i j li lj /eqP.
  rewrite -[i]/(val (Ordinal li : G)) -[j]/(val (Ordinal lj : G)) endsE => /andP[s t].
  by congr val; exact: S.
apply/allP=> p /mapP[i]; rewrite mem_iota => li ->; pose x : G := Ordinal li.
rewrite -[X in ~~ X]/(vertex (val x) == vertex (val (alpha x))) lv; apply/negP=> c.
by case/eqP: (alpha_neq x); apply/esym/(S _ _ c); rewrite alphaK at_same_vertex_sym.
Qed.
End InNumbers.

(* ---- The same map under other names ---- *)
Definition renaming (G H : combinatorial_map) (f : G -> H) :=
  [/\ bijective f, forall d, f (sigma d) = sigma (f d) & forall d, f (alpha d) = alpha (f d)].

Section SameMap.
Variables (G H : combinatorial_map) (f : G -> H).
Hypotheses (f_bij : bijective f) (f_sigma : forall d, f (sigma d) = sigma (f d)).
Hypothesis f_alpha : forall d, f (alpha d) = alpha (f d).
Let f_inj : injective f := bij_inj f_bij.

Lemma same_turn k d : f (iter k sigma d) = iter k sigma (f d).
Proof. by elim: k => //= k <-; exact: f_sigma. Qed.

Lemma same_at_vertex x y : at_same_vertex (f x) (f y) = at_same_vertex x y.
Proof.
apply/idP/idP=> [c|/iter_findex <-]; last by rewrite same_turn; exact: fconnect_iter.
have := iter_findex c; rewrite -same_turn => /f_inj <-; exact: fconnect_iter.
Qed.

Lemma same_degree d : degree (f d) = degree d.
Proof.
rewrite /degree /order -(card_image f_inj); apply: eq_card => y; have [g _ gK] := f_bij.
by rewrite -(gK y) (fintype.mem_image f_inj) -!topredE /= -/(at_same_vertex _ _) same_at_vertex.
Qed.

Lemma same_edges : edges G = edges H.
Proof. by apply: double_inj; rewrite !edges_double; exact: bij_eq_card f_bij. Qed.

Lemma same_cycles (p : G -> G) (q : H -> H) : injective p -> injective q ->
  (forall d, f (p d) = q (f d)) -> fcard p G = fcard q H.
Proof.
move=> pi qi fp; have [g fK gK] := f_bij; have sym := fconnect_sym pi.
have gq y : g (q y) = p (g y) by apply: f_inj; rewrite fp !gK.
have gc x y : fconnect q x y -> fconnect p (g x) (g y).
  move/iter_findex <-; elim: (findex _ _ _) => [|k IH] /=; first exact: connect0.
  by rewrite gq; apply: connect_trans IH (fconnect1 _ _).
have fc x y : fconnect p x y -> fconnect q (f x) (f y).
  move/iter_findex <-; elim: (findex _ _ _) => [|k IH] /=; first exact: connect0.
  by rewrite fp; apply: connect_trans IH (fconnect1 _ _).
have in_cycle y : fconnect q y (f (froot p (g y))).
  by rewrite -{1}(gK y); apply: fc; exact: connect_root.
rewrite (fcard_chosen qi in_cycle) => [|x y /gc /(rootP sym) -> //].
rewrite /n_comp_mem -(card_image f_inj); apply: eq_card => y; rewrite -(gK y) (fintype.mem_image f_inj) !inE andbT.
by rewrite (inj_eq f_inj) fK.
Qed.

Lemma same_vertices : vertices G = vertices H.
Proof. by apply: same_cycles => //; exact: sigma_inj. Qed.

Lemma same_planar : planar_map G <-> planar_map H.
Proof.
have faces_inj (K : combinatorial_map) : injective (fun d : K => sigma (alpha d)).
  by move=> x y /sigma_inj /alpha_inj.
rewrite /planar_map same_vertices same_edges /faces.
by rewrite (same_cycles (faces_inj G) (faces_inj H)) // => d; rewrite f_sigma f_alpha.
Qed.

Lemma same_simple : simple_world G -> simple_world H.
Proof.
move=> S x y; have [g _ gK] := f_bij; rewrite -(gK x) -(gK y) -!f_alpha !same_at_vertex => a b.
by congr f; exact: S.
Qed.

Lemma same_rooted d : isomorphic (rooted d) (rooted (f d)).
Proof. by have [g fK gK] := f_bij; exists f, g; split=> //= x _; split. Qed.
End SameMap.

(* ---- The same world under other names ---- *)
Definition same_world (W V : lighthouse_world) (f : W -> V) :=
  [/\ bijective f, forall d, f (sigma d) = sigma (f d), forall d, f (alpha d) = alpha (f d),
      f start = start & f pointed = pointed].

Lemma same_percept (W V : lighthouse_world) (f : W -> V) : same_world f ->
  forall d, percept_of (f d) = percept_of d.
Proof.
case=> fb fs fa _ fp d; apply: percept_transfer => j; rewrite -same_turn // -?fp;
  exact: (inj_eq (bij_inj fb)).
Qed.

(* an explorer in two worlds that it cannot tell apart: it ends in darts that are related *)
Section Related.
Variables (P E : Type) (X : explorer P E) (M N : rooted_map).
Variables (oM : carrier M -> P) (oN : carrier N -> P) (R : carrier M -> carrier N -> Prop).
Hypotheses (Ro : forall x y, R x y -> oM x = oN y) (R0 : R (root M) (root N)).
Hypothesis Rs : forall x y, R x y -> R (sigma_of M x) (sigma_of N y).
Hypothesis Ra : forall x y, R x y -> R (alpha_of M x) (alpha_of N y).

Lemma related_episode budget :
  (episode X M oM budget).1 = (episode X N oN budget).1 /\
  R (episode X M oM budget).2 (episode X N oN budget).2.
Proof.
have E1 := twins_episode X Ro Rs Ra R0 budget; split=> //.
rewrite /episode !explore_walk -/(episode X M oM budget) -/(episode X N oN budget) E1.
elim: (unzip1 _) (root M) (root N) R0 => //= k w IH x y Rxy; apply: IH.
exact: bisimulation_motion.
Qed.
End Related.

(* ---- Every world can be written down ---- *)
Lemma degree_in_numbers M (V : valid M) (C : connected (denote M)) (i : in_numbers V C) :
  degree_at M (val i) = degree i.
Proof. exact: (congr1 fst (@sensed_percept M V C 0 i)). Qed.

Theorem written_down (W : lighthouse_world) : exists M k,
  [/\ M \in rooted_maps (edges W), k < degree_at M (root_number M) &
    exists (V : valid M) (C : connected (denote M)) (f : W -> world_of_numbers V C k), same_world f].
Proof.
have [M lM [f [g [F G f0]]]] := rooted_maps_complete (@start W) (erefl (edges W)).
have [V C _] := rooted_maps_sound lM; rewrite /= in f F G f0.
have fl d : f d < size (sigma_list M) by have [] := F d isT.
pose h (d : W) : in_numbers V C := Ordinal (fl d).
have hs d : h (sigma d) = sigma (h d) by apply: val_inj; have [_ _ E _] := F d isT; exact: E.
have ha d : h (alpha d) = alpha (h d) by apply: val_inj; have [_ _ _ E] := F d isT; exact: E.
have hb : bijective h.
  exists (fun i => g (val i)) => [d|i]; first by have [_ E _ _] := F d isT; exact: E.
  by apply: val_inj; have [_ E] := G _ (ltn_ord i); exact: E.
have h0 : h start = ord_root V by exact: val_inj.
exists M, (first_bearing W); split=> //.
  rewrite -[root_number M]/(val (ord_root V : in_numbers V C)) degree_in_numbers -h0.
  by rewrite same_degree //; exact: findex_max (@pointed_at_v0 W).
exists V, C, h; split=> //; rewrite -(iter_findex (@pointed_at_v0 W)) same_turn //=.
by rewrite -h0.
Qed.
