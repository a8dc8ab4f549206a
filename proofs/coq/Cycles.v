(* ---------------------------------------------------------------------------------------------
   Cycles: told apart with position, and explored with m traversals.            Sections III, VI, VII

     position_on_cycle d  what a robot with position only senses on a cycle: degree 2, and whether the
                          vertex is the one where it started.
     round_once           the explorer that walks on until it is back, and counts.
     round_once_right     it is right on every cycle: with position cycles of different length are told
                          apart.
     ring k b             the cycle of k+1 vertices as a lighthouse_world; b: the marker points along the
                          start dart or along the other dart of v0.
     lifo_on_ring         Algorithm 1, last in first out, walks exactly m edges there, and is right: 2m
                          is no lower bound, and m is met.
   --------------------------------------------------------------------------------------------- *)
From mathcomp Require Import all_ssreflect.
From Allworlds Require Import Model Maps Percepts RootedMaps Explorers PartialMaps Routes Algorithm.
From Allworlds Require Import Execution Refinement Policies Impossibility PathWorlds.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(* ---- With position, cycles are told apart ---- *)
Definition position_on_cycle (d : nat * bool) := (2, d.1 == 0).
Definition round_once : explorer (nat * bool) nat := fun seen =>
  if (1 < size seen) && (last (0, false) seen).2 then Stop (size seen).-1 else Move 1.

(* going round the other way is the same cycle, seen from the other side *)
Lemma modn_cancel n c a b : a < n -> b < n -> a + c = b + c %[mod n] -> a = b.
Proof. by move=> la lb /eqP; rewrite eqn_modDr !modn_small // => /eqP. Qed.

Lemma cycle_reversed n : 0 < n -> isomorphic (cycle_world n true) (cycle_world n false).
Proof.
move=> n0; pose f (d : nat * bool) := ((n - d.1) %% n, ~~ d.2).
have fl d : (f d).1 < n by rewrite ltn_mod.
have back i : i < n -> (n - i) %% n + i = 0 %[mod n].
  by move=> li; rewrite modnDml subnK ?modnn ?mod0n // ltnW.
have ff d : d.1 < n -> f (f d) = d.
  case: d => i c /= li; rewrite /f /= negbK; congr (_, _); apply: (@modn_cancel n ((n - i) %% n)) => //.
    by rewrite ltn_mod.
  by rewrite back ?ltn_mod // addnC back.
exists f, f; split=> [d ld|d ld|]; [|by split; [exact: fl | exact: ff]|by rewrite /f /= subn0 modnn].
rewrite ff //; split; [exact: fl | by [] | by [] |]; case: d ld => i c /= li.
rewrite /f /cycle_alpha /= negbK; case: c => /=; congr (_, _).
  apply: (@modn_cancel n ((i + n.-1) %% n)); rewrite ?ltn_mod // back ?ltn_mod // modnDmr modnDml.
  by rewrite addSn -!addnS prednK // addnA modnDr back.
apply: (@modn_cancel n (i.+1 %% n)); rewrite ?ltn_mod // back ?ltn_mod // modnDmr modnDml.
by rewrite addnS -addSn -addnS prednK // addnAC modnDr back.
Qed.

Theorem round_once_right n side : 0 < n ->
  right (fun n => cycle_world n true) round_once (cycle_world n side) position_on_cycle.
Proof.
move=> n0; pose W := cycle_world n side; pose d j := iter j (motion_in W 1) (0, side).
have dE j : d j = ((if side then j else (n - 1) * j) %% n, side).
  elim: j => [|j IH]; first by rewrite /d /= muln0 if_same mod0n.
  rewrite [d _]/= -/(d j) IH /motion_in /= /cycle_alpha /= negbK; case: (side) => /=; congr (_, _).
    by rewrite -addn1 modnDml addn1.
  by rewrite modnDml mulnS addnC subn1.
have at0 j : j < n -> ((d j).1 == 0) = (j == 0).
  move=> lj; rewrite dE /=; case: (side); first by rewrite modn_small.
  apply/eqP/eqP=> [E|->]; last by rewrite muln0 mod0n.
  apply: (@modn_cancel n ((n - 1) * j)) => //; rewrite add0n E; symmetry.
  by rewrite -{1}[j]mul1n -mulnDl subnKC // modnMr.
have dn : d n = (0, side) by rewrite dE; case: (side); rewrite ?modnn ?modnMl.
have run j m seen : j + m = n -> size seen = j.+1 -> 0 < m ->
    last (0, false) seen = position_on_cycle (d j) -> (0 < j -> ~~ ((d j).1 == 0)) -> exists t,
    explore round_once W position_on_cycle m seen (d j) = (t, Some n, d n).
  elim: m j seen => // m IH j seen jm sz _ la away; rewrite /= /round_once sz la /=.
  have -> : (1 < j.+1) && ((d j).1 == 0) = false.
    by rewrite ltnS; apply/negP=> /andP[/away/negbTE->].
  have := IH j.+1 (rcons seen (position_on_cycle (d j.+1))); rewrite addSn -addnS size_rcons sz.
  case: m jm {IH} => [|m] jm IH; last first.
    have lj : j.+1 < n by rewrite -jm !addnS !ltnS leq_addr.
    have [//|//|//|||t ->] := IH; rewrite ?last_rcons //; first by rewrite at0.
    by eexists.
  have jn : j.+1 = n by rewrite -jm addn1.
  have E0 : explore round_once W position_on_cycle 0 (rcons seen (position_on_cycle (d j.+1))) (d j.+1)
    = ([::], Some n, d n).
    by rewrite jn dn /= /round_once size_rcons sz jn last_rcons /= ltnS n0.
  by rewrite -[cycle_alpha _ _]/(d j.+1) E0; eexists.
have [|||||t E] := run 0 n [:: position_on_cycle (d 0)] => //.
exists n, t, n, (d n); split; [exact: E | exact: cycle_wellformed |].
rewrite dn; case: (side); first exact: isomorphic_refl.
exact: cycle_reversed.
Qed.

(* ---- The cycle as a world with a lighthouse ---- *)
Section Ring.
Variables (k : nat) (b : bool).
Local Notation dart := ('I_k.+1 * bool)%type.

Definition ring_sigma (d : dart) : dart := (d.1, ~~ d.2).
Definition ring_alpha (d : dart) : dart := (iter (if d.2 then k else 1) (@after k) d.1, ~~ d.2).

Lemma ring_sigma_inj : injective ring_sigma.
Proof. by move=> [i c] [j c'] [-> /negb_inj ->]. Qed.

Lemma ring_alphaK : involutive ring_alpha.
Proof.
case=> i c; rewrite /ring_alpha /= negbK -iterD; congr (_, _).
by rewrite (_ : _ + _ = k.+1) ?after_full //; case: c; rewrite ?addn1.
Qed.

Lemma ring_alpha_neq d : ring_alpha d != d.
Proof. by case: d => i []; apply/eqP=> -[]. Qed.

(* on the ring: j steps from the start *)
Definition on_ring j : dart := (iter j (@after k) ord0, true).

Lemma ring_connected x y : connect (adjacent ring_sigma ring_alpha) x y.
Proof.
set e := adjacent _ _; have sym := adjacent_connect_sym ring_sigma_inj ring_alphaK.
have cs d : connect e d (ring_sigma d) by apply: connect1; rewrite /e /adjacent eqxx.
have ca d : connect e d (ring_alpha d) by apply: connect1; rewrite /e /adjacent eqxx orbT.
suff H d : connect e (on_ring 0) d by apply: connect_trans (H y); rewrite sym; exact: H.
have R j : connect e (on_ring 0) (on_ring j).
  elim: j => [|j IH]; first exact: connect0.
  by apply: connect_trans IH (connect_trans (cs _) _); exact: (ca (ring_sigma (on_ring j))).
case: d => i c; have T : connect e (on_ring 0) (i, true).
  by have := R (k.+1 - 0 + i); rewrite /on_ring (after_reaches ord0 i).
by case: c => //; exact: connect_trans T (cs (i, true)).
Qed.

Definition ring_map := CombinatorialMap ring_sigma_inj ring_alphaK ring_alpha_neq ring_connected.

Lemma ring_pointed : @at_same_vertex ring_map (on_ring 0) (ord0, b).
Proof. by case: b; [exact: connect0 | exact: (fconnect1 (@sigma ring_map) (on_ring 0))]. Qed.

Definition ring := LighthouseWorld ring_pointed.

Lemma ring_vertex (x y : ring) : at_same_vertex x y -> x.1 = y.1.
Proof. by move/iter_findex <-; elim: (findex _ _ _) => //= j ->. Qed.

Lemma ring_degree (d : ring) : degree d = 2.
Proof.
apply: order_least => //; first exact: ring_sigma_inj; first by case: d => i [].
by case=> [|[|j]] // _; case: d => i [].
Qed.

Lemma edges_ring : edges ring = k.+1.
Proof. by apply: double_inj; rewrite edges_double card_prod card_ord card_bool muln2. Qed.

Lemma vertices_ring : vertices ring = k.+1.
Proof.
apply/eqP; rewrite -(eqn_pmul2r (m := 2)) //; apply/eqP.
rewrite /vertices (fcard_order_set (n := 2) ring_sigma_inj) //; last first.
  by apply/subsetP=> d _; rewrite inE -/(degree (d : ring)) ring_degree.
by rewrite card_prod card_ord card_bool.
Qed.

Local Notation v0 := (@start ring).

Lemma ring_percept j : 0 < j < k.+1 -> percept_of (on_ring j : ring) = (2, None).
Proof.
case/andP=> j0 lj; rewrite /percept_of ring_degree /bearing; case: ifP => // /ring_vertex E.
have : val (iter j (@after k) ord0) = 0 by have /(congr1 val) := E.
by rewrite after_turn add0n modn_small // => e0; rewrite e0 in j0.
Qed.

Lemma ring_percept0 : percept_of v0 = (2, Some (first_bearing ring)).
Proof. by rewrite /percept_of ring_degree bearing_start. Qed.

Lemma ring_motion j : motion 3 (on_ring j : ring) = on_ring j.+1.
Proof. by []. Qed.

Lemma ring_round : on_ring k.+1 = v0.
Proof. by rewrite /on_ring after_full. Qed.

Lemma ring_bearing : first_bearing ring < 2.
Proof. by have := findex_max (@pointed_at_v0 ring); rewrite -/(degree v0) ring_degree. Qed.

(* ---- Algorithm 1, last in first out ---- *)

(* what it knows after i passes: a path of i+1 vertices, open at both ends *)
Fixpoint path_known i :=
  if i is i'.+1 then add_vertex (path_known i') (i', 1) 2 else initial_map 2.
Definition knowledge_on_ring i :=
  Knowledge (path_known i) [:: (0, 0); (i, 1)] (first_bearing ring) (i, 0) 0.

Lemma path_degrees i : degrees (path_known i) = nseq i.+1 2.
Proof. by elim: i => //= i ->; elim: i => //= i ->. Qed.

Lemma path_degree i v : v <= i -> degree_in (path_known i) v = 2.
Proof. by move=> le; rewrite /degree_in path_degrees nth_nseq ltnS le. Qed.

Local Notation machine := (machine directional lifo motion (@percept_of ring)).

Lemma way_on_ring i : way_to lifo (knowledge_on_ring i) (i, 1) = ([::], (i, 0)).
Proof. by rewrite /way_to /route_or_else /= eqxx path_degrees. Qed.

Lemma edge_on_ring i : next_edge lifo (knowledge_on_ring i) = (i, 1).
Proof. by rewrite /next_edge /= !inE eqxx orbT. Qed.

Lemma expected_home i :
  expected_percept (first_bearing ring) (path_known i) (0, 0) = (2, Some (first_bearing ring)).
Proof. by rewrite /expected_percept path_degree //= modnDr modn_small // ring_bearing. Qed.

Lemma lifo_hypotheses K e o : hypotheses directional lifo K e o =
  [seq h <- unexplored K | (h != e) && (expected_percept (bearing0 K) (known_map K) h == o)].
Proof. by rewrite /hypotheses /= perm_refl. Qed.

Lemma step_on_ring i : i < k ->
  exec (@percept_of ring) (one_pass directional lifo (knowledge_on_ring i)) (on_ring i)
  = (knowledge_on_ring i.+1, on_ring i.+1, [:: (3, (2, None))]).
Proof.
move=> li; have P : percept_of (on_ring i.+1 : ring) = (2, None) by apply: ring_percept.
rewrite /one_pass edge_on_ring way_on_ring /= path_degree // add0n.
rewrite -[2 - 0 + 1]/3 -[ring_alpha _]/(on_ring i.+1) P lifo_hypotheses /= expected_home.
rewrite eqxx !xpair_eqE !andbF /=.
by rewrite eqxx xpair_eqE andbF /knowledge_on_ring /new_dart path_degrees size_nseq.
Qed.

Lemma last_on_ring : exists k', unexplored k' = [::] /\
  exec (@percept_of ring) (one_pass directional lifo (knowledge_on_ring k)) (on_ring k)
  = (k', v0, [:: (3, percept_of v0)]).
Proof.
rewrite /one_pass edge_on_ring way_on_ring /= path_degree // add0n.
rewrite -[2 - 0 + 1]/3 -[ring_alpha _]/(on_ring k.+1) ring_round ring_percept0 lifo_hypotheses /=.
rewrite expected_home !eqxx xpair_eqE andbF /= /way_home /route_or_else /= path_degrees /=.
rewrite expected_home eqxx /=.
by eexists; split; last by []; rewrite /= !eqxx xpair_eqE andbF.
Qed.

(* the whole run: k+1 motions, and nothing is open *)
Lemma run_on_ring i : i <= k -> exists t answer z,
  machine (k.+1 - i) (Return (knowledge_on_ring i)) (on_ring i) = (t, Some answer, z) /\
  size t = k.+1 - i.
Proof.
have [j] := ubnP (k - i); elim: j i => // j IH i lj le; rewrite (machine_next _ _ _ (next_pass _ _ _)) //.
move: le; rewrite leq_eqVlt => /orP[/eqP ik|li].
  have [K' [U E]] := last_on_ring; rewrite ik subSnn.
  exists [:: (3, percept_of v0)], (estimate K'), v0; split=> //.
  by apply: (machine_exec (fuel := 0) E); rewrite /= U.
have [|//|t [answer [z [A s]]]] := IH i.+1.
  by rewrite ltnS in lj; apply: leq_trans lj; rewrite ltn_sub2l.
exists ((3, (2, None)) :: t), answer, z; rewrite /= s subSn ?(ltnW li) // subSS; split=> //.
exact: (machine_exec (step_on_ring li) A).
Qed.
End Ring.

Theorem lifo_on_ring k b (W := ring k b) budget : edges W <= budget -> exists t answer z,
  [/\ episode (algorithm1 lifo) (rooted (@start W)) (@percept_of W) budget = (t, Some answer, z),
      size t = edges W, valid answer & isomorphic (denote answer) (rooted z)].
Proof.
rewrite edges_ring => le; have [t [answer [z [A s]]]] := run_on_ring b (leq0n k).
have R : episode (algorithm1 lifo) (rooted (@start W)) (@percept_of W) k.+1 = (t, Some answer, z).
  rewrite episode_machine [set_out _ _](_ : _ = Return (knowledge_on_ring k b 0)); first exact: A.
  by rewrite [percept_of _]ring_percept0.
have [t' [answer' [z' [R' _ V I]]]] :=
  algorithm1_correct lifo (leqnn (paper_bound (vertices W) (edges W))).
have [_ ee zz] := explore_once R R'; subst answer' z'.
by exists t, answer, z; split=> //; rewrite -(subnKC le); exact: explore_more.
Qed.
