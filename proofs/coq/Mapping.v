(* ---------------------------------------------------------------------------------------------
   What it means that a sensor suffices: worlds of bounded size can be mapped.               Section III

   A sensor suffices if and only if for every m there is an explorer that is right in all worlds with at most
   m edges.  It walks a list of motions, the same in all of them, that tells apart all those worlds that any
   motions tell apart, and answers with the first world of a list of all that looks as what it has seen.

     reach_word           turns and crossings are motions.
     one_walk             one list of motions for finitely many pairs of worlds.
     walker v answer      the explorer that walks v and then answers.
     listed_worlds        a list of the worlds with at most m edges, each indistinguishable from one of them.
     sufficient_iff_mapped   the theorem.
   --------------------------------------------------------------------------------------------- *)
From mathcomp Require Import all_ssreflect.
From Allworlds Require Import Model Maps Percepts RootedMaps Codes Explorers Indistinguishable.
From Allworlds Require Import PositionTwins Ambiguity NumberedWorlds Judge Enumeration SameWorld Sensors.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(* ---- Two worlds and a list of motions ---- *)
Lemma percepts_hd P (M : rooted_map) (obs : carrier M -> P) w d :
  percepts_in obs w d = obs d :: behead (percepts_in obs w d).
Proof. by case: w. Qed.

Lemma percepts_in_last P (M : rooted_map) (obs : carrier M -> P) w d o :
  last o (percepts_in obs w d) = obs (walk_in M w d).
Proof. by elim: w d o => //= k w IH d o; rewrite IH. Qed.

Lemma percepts_in_cat P (M N : rooted_map) (oM : carrier M -> P) (oN : carrier N -> P) v w d e :
  percepts_in oM (v ++ w) d = percepts_in oN (v ++ w) e ->
  percepts_in oM v d = percepts_in oN v e /\
  percepts_in oM w (walk_in M v d) = percepts_in oN w (walk_in N v e).
Proof.
elim: v d e => [|k v IH] d e /= => [E|[-> /IH[-> ->]]] //; split=> //.
by move: E; rewrite percepts_hd [RHS]percepts_hd => -[->].
Qed.

Section TwoWorlds.
Variables (G H : combinatorial_map) (P : eqType) (sG : G -> P) (sH : H -> P).
Implicit Types (x : G) (y : H).

Lemma walk_rooted (d : G) w x : walk_in (rooted d) w x = walk w x.
Proof. by elim: w x => //= k w IH x; rewrite IH. Qed.

Lemma reach_word x y u v : paired x y u v -> exists w, walk w x = u /\ walk w y = v.
Proof.
case/connectP=> p; elim: p x y => [|[a b] p IH] x y /=; first by move=> _ [-> ->]; exists [::].
case/andP=> /orP[] /eqP[-> ->] S E; have [w [<- <-]] := IH _ _ S E; last by exists (0 :: w).
by exists [:: 1, 0 & w]; rewrite /= /motion /= !alphaK.
Qed.

Lemma walk_paired w x y : paired x y (walk w x) (walk w y).
Proof.
elim: w x y => [|k w IH] x y /=; first exact: connect0.
apply: connect_trans (IH _ _); apply: paired_alpha; elim: k => [|k K] /=; first exact: connect0.
exact: paired_sigma.
Qed.

Lemma paired_sym x y u v : paired x y u v -> paired u v x y.
Proof.
have := @adjacent_connect_sym _ (fun p : G * H => (sigma p.1, sigma p.2)) (fun p => (alpha p.1, alpha p.2)).
move=> S; rewrite /paired; have -> // : connect (@paired_step G H) (u, v) (x, y)
    = connect (@paired_step G H) (x, y) (u, v).
apply: S; first by move=> [a b] [a' b'] /= [/sigma_inj-> /sigma_inj->].
by move=> [a b] /=; rewrite !alphaK.
Qed.

Lemma indistinct_paired x y u v : paired x y u v -> indistinct sG sH x y -> indistinct sG sH u v.
Proof.
move=> p /forallP I; apply/forallP=> a; apply/forallP=> c; apply/implyP=> q.
by have /forallP/(_ c)/implyP := I a; apply; exact: connect_trans p q.
Qed.

(* what is told apart stays so *)
Lemma indistinct_back w x y : indistinct sG sH (walk w x) (walk w y) -> indistinct sG sH x y.
Proof. apply: indistinct_paired; apply: paired_sym; exact: walk_paired. Qed.

Lemma told_apart_by d e x y : ~~ indistinct sG sH x y -> exists w,
  percepts_in (M := rooted d) sG w x <> percepts_in (M := rooted e) sH w y.
Proof.
case/forallPn=> u /forallPn[v]; rewrite negb_imply => /andP[/reach_word[w [<- <-]] /eqP N].
exists w => E; apply: N; have := congr1 (last (sG x)) E.
rewrite (@percepts_in_last _ (rooted d)) (@percepts_in_last _ (rooted e)).
by rewrite walk_rooted (_ : walk_in (rooted e) w y = walk w y) //; elim: (w) (y) => //= k q IH z; rewrite IH.
Qed.
End TwoWorlds.

Section Sensor.
Variables (A : eqType) (lambda : sensor A).
Local Notation senses W := (percept_by lambda (W := W)).
Local Notation seen W w := (percepts_in (M := rooted (@start W)) (senses W) w start).

Lemma indistinguishable_seen (W V : lighthouse_world) :
  indistinguishable lambda W V <-> forall w, seen W w = seen V w.
Proof.
have [WW WV] := (rooted_wellformed (@start W), rooted_wellformed (@start V)).
split=> [[R [Ro Rs Ra R0]] w|E].
  have [|//|//|_ _] := @bisimulation_alike _ (rooted start) (rooted start) (senses W) (senses V) R
    _ _ _ _ _ R0.
    by move=> x y /Ro.
  exact.
exists (alike (M := rooted start) (N := rooted start) (senses W) (senses V)); split=> //.
- by move=> x y /alike_percept.
- by move=> x y; exact: (alike_sigma WW WV).
by move=> x y; exact: (alike_alpha WW WV).
Qed.

Lemma one_walk (V : nat -> lighthouse_world) (pairs : seq (nat * nat)) :
  exists v, forall i j, (i, j) \in pairs -> seen (V i) v = seen (V j) v ->
  indistinguishable lambda (V i) (V j).
Proof.
elim: pairs => [|[i j] pairs [v H]]; first by exists [::].
have keep w i' j' : (i', j') \in pairs -> seen (V i') (v ++ w) = seen (V j') (v ++ w) ->
    indistinguishable lambda (V i') (V j').
  by move=> l /percepts_in_cat[E _]; exact: H.
case: (boolP (indistinct (senses (V i)) (senses (V j)) start start)) => [I|N].
  exists v => i' j'; rewrite inE => /orP[/eqP[-> ->] _|]; last exact: H.
  by apply/indistinguishable_seen; case/(indistinct_alikeP _ _ start start): I.
have N' := contra (@indistinct_back _ _ _ _ _ v _ _) N.
have [w D] := told_apart_by start start N'.
exists (v ++ w) => i' j'; rewrite inE => /orP[/eqP[-> ->]|]; last exact: keep.
by case/percepts_in_cat=> _; rewrite !walk_rooted.
Qed.

(* ---- The explorer ---- *)
Definition walker P E v (answer : seq P -> E) : explorer P E := fun seen =>
  if (size seen).-1 < size v then Move (nth 0 v (size seen).-1) else Stop (answer seen).

Lemma walker_episode P E v (answer : seq P -> E) (M : rooted_map) (obs : carrier M -> P) :
  exists t, episode (walker v answer) M obs (size v)
    = (t, Some (answer (percepts_in obs v (root M))), walk_in M v (root M)).
Proof.
suff H w u h d : v = u ++ w -> size h = (size u).+1 -> exists t,
    explore (walker v answer) M obs (size w) h d
    = (t, Some (answer (h ++ behead (percepts_in obs w d))), walk_in M w d).
  by have [t] := H v [::] [:: obs (root M)] (root M) erefl erefl; exists t; rewrite percepts_hd.
elim: w u h d => [|k w IH] u h d D s; rewrite /= {1}/walker s /= (congr1 size D) size_cat.
  by rewrite addn0 ltnn; exists [::]; rewrite cats0.
have nk : nth 0 v (size u) = k by rewrite D nth_cat ltnn subnn.
rewrite -addSnnS leq_addr /= nk.
have [||t T] := IH (rcons u k) (rcons h (obs (motion_in M k d))) (motion_in M k d).
- by rewrite cat_rcons.
- by rewrite !size_rcons s.
by rewrite T; eexists; rewrite cat_rcons -percepts_hd.
Qed.

Lemma isomorphic_walk (G H : combinatorial_map) (d : G) (e : H) w :
  isomorphic (rooted d) (rooted e) -> isomorphic (rooted (walk w d)) (rooted (walk w e)).
Proof.
case=> f [g [F G' fd]]; rewrite /= in f g F G' fd; exists f, g; split=> //=.
have ft k x : f (iter k sigma x) = iter k sigma (f x).
  by elim: k => //= k <-; have [_ _ -> _] := F (iter k sigma x) isT.
have fw v x : f (walk v x) = walk v (f x).
  elim: v x => //= k v IH x; rewrite IH /motion; have [_ _ _ ->] := F (iter k sigma x) isT.
  by rewrite ft.
by rewrite fw fd.
Qed.

(* ---- The worlds in question ---- *)
Record candidate := Candidate {
  candidate_map : numbered_map;
  candidate_valid : valid candidate_map;
  candidate_connected : connected (denote candidate_map);
  candidate_bearing : nat }.
Definition candidate_world c :=
  world_of_numbers (candidate_valid c) (@candidate_connected c) (candidate_bearing c).

Lemma listed_codes (codes : seq (numbered_map * nat)) :
  (forall c, c \in codes -> valid c.1 /\ connected (denote c.1)) ->
  exists L : seq candidate, forall c0 M k, (M, k) \in codes ->
  exists i (V : valid M) (C : connected (denote M)), i < size L /\ nth c0 L i = Candidate V C k.
Proof.
elim: codes => [|[M k] codes IH] H; first by exists [::].
have [|L Ls] := IH; first by move=> c l; apply: H; rewrite inE l orbT.
have [V C] := H _ (mem_head _ _); exists (Candidate V C k :: L) => c0 M' k'.
rewrite inE => /orP[/eqP[-> ->]|/(Ls c0)[i [V' [C' [lt E]]]]]; first by exists 0, V, C.
by exists i.+1, V', C'.
Qed.

Hypothesis kept : invariant lambda.

Lemma same_world_seen (W V : lighthouse_world) (f : W -> V) : same_world f -> indistinguishable lambda W V.
Proof.
case=> fb fs fa f0 fp; exists (fun x y => f x = y); split=> [x y <-|x y <-|x y <-|] //.
by rewrite /percept_by same_degree // -fp kept.
Qed.

Lemma listed_worlds m : exists L : seq candidate, forall c0 (W : lighthouse_world), edges W <= m ->
  exists2 i, i < size L & indistinguishable lambda W (candidate_world (nth c0 L i)).
Proof.
pose codes := flatten [seq flatten [seq [seq (M, k) | k <- iota 0 (degree_at M (root_number M))]
  | M <- rooted_maps j] | j <- iota 0 m.+1].
have [|L H] := @listed_codes codes.
  move=> c /flatten_mapP[j _ /flatten_mapP[M lM /mapP[k _ ->]]].
  by have [V C _] := rooted_maps_sound lM.
exists L => c0 W le; have [M [k [lM lk [V [C [f F]]]]]] := written_down W.
have [|i [V' [C' [lt E]]]] := H c0 M k.
  apply/flatten_mapP; exists (edges W); first by rewrite mem_iota.
  by apply/flatten_mapP; exists M => //; apply/mapP; exists k; rewrite ?mem_iota.
exists i => //; rewrite E (eq_irrelevance V' V); exact: (@same_world_seen W (world_of_numbers V C' k) f F).
Qed.

Theorem sufficient_iff_mapped : sufficient lambda <->
  forall m, exists X : explorer (nat * A) numbered_map, forall W : lighthouse_world, edges W <= m ->
  right denote X (rooted (@start W)) (senses W).
Proof.
split=> [S m|H W V I]; last first.
  have [X R] := H (maxn (edges W) (edges V)); have [B [Bo Bs Ba B0]] := I.
  by apply: (@twins_impossible _ _ denote X (rooted start) (rooted start) (senses W) (senses V) B);
    rewrite ?leq_maxl ?leq_maxr //; try exact: rooted_wellformed; apply: R; rewrite ?leq_maxl ?leq_maxr.
have [[|c0 L0] HL] := listed_worlds m.
  exists (fun _ => Stop (NumberedMap [::] [::] 0)) => W le.
  by have [M [k [_ _ [V [C _]]]]] := written_down W; have [i] := HL (Candidate V C k) W le.
set L := c0 :: L0 in HL; pose world i := candidate_world (nth c0 L i).
pose indices := iota 0 (size L).
have [v tells] := one_walk world [seq (i, j) | i <- indices, j <- indices].
pose like p := find (fun i => seen (world i) v == p) indices.
pose place i : world i := walk v start.
pose answer p := seen_from (candidate_map (nth c0 L (like p))) (val (place (like p))).
exists (walker v answer) => W le; have [i li I] := HL c0 W le.
have EI := (indistinguishable_seen _ _).1 I; set p := seen W v.
have [lj Ej] : like p < size L /\ seen (world (like p)) v = p.
  have Hp : has (fun i => seen (world i) v == p) indices.
    by apply/hasP; exists i; [rewrite mem_iota | rewrite /p EI].
  have := Hp; rewrite has_find size_iota => lt; split=> //.
  by have := nth_find 0 Hp; rewrite nth_iota // => /eqP.
have J : indistinguishable lambda W (world (like p)).
  apply/indistinguishable_seen => u; rewrite EI; symmetry; apply: (proj1 (indistinguishable_seen _ _)).
  by apply: tells; [apply: allpairs_f; rewrite mem_iota | rewrite Ej /p EI].
have [t T] := walker_episode v answer (M := rooted (@start W)) (senses W).
exists (size v), t, (answer p), (walk v start); rewrite T walk_rooted; split=> //.
  apply: validP; apply: seen_from_valid; [exact: candidate_valid | exact: ltn_ord].
apply: isomorphic_trans (isomorphic_walk v (isomorphic_sym (rooted_wellformed _) (S _ _ J))).
apply: isomorphic_sym (rooted_wellformed _) _; exact: numbers_isomorphic.
Qed.
End Sensor.
