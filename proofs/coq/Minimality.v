(* ---------------------------------------------------------------------------------------------
   No smaller pair: small worlds that look alike when the position is marked are the same.
                                                                                        Section III

   A robot is put into each of the listed maps at once, and all make the same few motions.  Robots that
   sense different things are told apart; it is checked that of the robots that are never told apart all
   are in the same map.  Enumeration.v and SimpleMaps.v list all maps there are.

     cycle_of f d         the numbers d, f d, f (f d), .. of the cycle of d.
     position_table M     what is sensed in each dart of M, the marker lying at the root.
     robot                a map, its table, and the dart that the robot is in; put, look, moved.
     look_on_the_way w p  what it senses on the way of the motions w.
     told_apart same w    robots with the same percepts on the way of w are in maps that are `same`.
     the_same             equal lists of numbers: for canonical maps, the same rooted map.
     the_same_at_v0       planar maps that are the same, with v0 on v0, if the right start is chosen.

     simple_worlds_differ   ten motions tell all simple worlds with at most 5 edges apart.
     no_simple_twins, no_twins_with_one_edge
                            so worlds of these sizes that look alike are the same.
   Planar worlds: PlanarMinimality.v.
   --------------------------------------------------------------------------------------------- *)
From mathcomp Require Import all_ssreflect.
From Allworlds Require Import Model Maps RootedMaps Codes Indistinguishable NumberedWorlds Enumeration.
From Allworlds Require Import Judge Twins Cluster SameWorld PositionTwins SimpleMaps.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(* ---- The program ---- *)
(* `all`, but what follows a failure is not computed: vm_compute knows no lazy conjunction *)
Fixpoint every (T : Type) (p : T -> bool) s :=
  if s is x :: s' then if p x then every p s' else false else true.

Lemma everyE T (p : T -> bool) s : every p s = all p s.
Proof. by elim: s => //= x s <-; case: (p x). Qed.

Fixpoint cycle_from (f : nat -> nat) (d x : nat) fuel : seq nat :=
  if fuel is fuel'.+1 then if x == d then [::] else x :: cycle_from f d (f x) fuel' else [::].
Definition cycle_of f (d : nat) n := d :: cycle_from f d (f d) n.

Definition position_table M :=
  let n := size (sigma_list M) in
  let vertex d := cycle_of (nth 0 (sigma_list M)) d n in
  let v0 := vertex (root_number M) in
  [seq (size (vertex d), d \in v0) | d <- iota 0 n].

(* what is computed once for each map: whether it is planar, and its table *)
Definition robot := (numbered_map * bool * seq (nat * bool) * nat)%type.
Implicit Type p q : robot.
Definition put M : robot := (M, planar_in M, position_table M, root_number M).
Definition look p := nth (0, false) p.1.2 p.2.
Definition moved k p : robot :=
  let M := p.1.1.1 in (p.1, nth 0 (alpha_list M) (iter k (nth 0 (sigma_list M)) p.2)).
Fixpoint look_on_the_way w p := look p :: (if w is k :: w' then look_on_the_way w' (moved k p) else [::]).

Section ToldApart.
Variable same : numbered_map -> bool -> numbered_map -> bool -> bool.
Implicit Type G : seq robot.

Definition all_same G := every (fun p => every (fun q => same p.1.1.1 p.1.1.2 q.1.1.1 q.1.1.2) G) G.

(* robots that sense the same are put together; groups: each with what its robots sense *)
Fixpoint join p (groups : seq ((nat * bool) * seq robot)) :=
  if groups is g :: groups' then
    if g.1 == look p then (g.1, p :: g.2) :: groups' else g :: join p groups'
  else [:: (look p, [:: p])].
Definition by_look G := [seq g.2 | g <- foldr join [::] G].

Definition few G := if G is [:: _, _, _, _ & _] then false else true.
Fixpoint told_on_the_way w G :=
  if w is k :: w' then
    if (if few G then all_same G else false) then true
    else every (told_on_the_way w') (by_look [seq moved k p | p <- G])
  else all_same G.
Definition told_apart w (L : seq numbered_map) := every (told_on_the_way w) (by_look (map put L)).

Lemma by_look_filter o G : [seq p <- G | look p == o] != [::] ->
  [seq p <- G | look p == o] \in by_look G.
Proof.
pose members := fix members groups : seq robot :=
  if groups is g :: groups' then if g.1 == o then g.2 else members groups' else [::].
have join_members p groups :
    members (join p groups) = if look p == o then p :: members groups else members groups.
  elim: groups => [|g groups IH] /=; first by case: ifP.
  case: (g.1 =P look p) => /= [->|ne]; first by case: ifP.
  by rewrite IH; case: (g.1 =P o) => // E; case: (look p =P o) => // E'; case: ne; rewrite E E'.
have -> : [seq p <- G | look p == o] = members (foldr join [::] G).
  by elim: G => //= p G ->; rewrite join_members.
rewrite /by_look; elim: (foldr _ _ _) => //= g groups IH; case: ifP => _ ne; first exact: mem_head.
by rewrite inE IH ?orbT.
Qed.

Lemma by_look_mem G p q : p \in G -> q \in G -> look p = look q ->
  exists2 G', G' \in by_look G & (p \in G') && (q \in G').
Proof.
move=> mp mq E; exists [seq r <- G | look r == look p]; last by rewrite !mem_filter mp mq E eqxx.
apply: by_look_filter; apply/eqP=> F.
by have : p \in [::] by rewrite -F mem_filter eqxx.
Qed.

Lemma all_same_sound G p q : all_same G -> p \in G -> q \in G -> same p.1.1.1 p.1.1.2 q.1.1.1 q.1.1.2.
Proof.
by rewrite /all_same everyE => /allP H mp mq; have := H p mp; rewrite everyE => /allP/(_ q mq).
Qed.

Lemma told_on_the_way_sound w G p q : told_on_the_way w G -> p \in G -> q \in G ->
  look_on_the_way w p = look_on_the_way w q -> same p.1.1.1 p.1.1.2 q.1.1.1 q.1.1.2.
Proof.
elim: w G p q => [|k w IH] G p q /=; first by move=> H mp mq _; exact: all_same_sound H mp mq.
case: ifP => [|_]; first by case: ifP => // _ H _ mp mq _; exact: all_same_sound H mp mq.
rewrite everyE => /allP H mp mq [_ E].
have E0 : look (moved k p) = look (moved k q) by move: E; case: (w) => [|? ?] [].
have [|| G' mG /andP[mp' mq']] := @by_look_mem [seq moved k r | r <- G] _ _ _ _ E0; try exact: map_f.
exact: (IH _ _ _ (H _ mG) mp' mq' E).
Qed.

Theorem told_apart_sound w L M N : told_apart w L -> M \in L -> N \in L ->
  look_on_the_way w (put M) = look_on_the_way w (put N) -> same M (planar_in M) N (planar_in N).
Proof.
rewrite /told_apart everyE => /allP H lM lN E.
have E0 : look (put M) = look (put N) by move: E; case: (w) => [|? ?] [].
have [|| G' mG /andP[mp mq]] := @by_look_mem (map put L) _ _ _ _ E0; try exact: map_f.
exact: told_on_the_way_sound (H _ mG) mp mq E.
Qed.
End ToldApart.

(* ---- What the robots sense is what is sensed in the maps ---- *)
Section InNumbers.
Variables (M : numbered_map) (V : valid M) (C : connected (denote M)).
Local Notation G := (in_numbers V C).
Local Notation n := (size (sigma_list M)).
Local Notation sigma_in := (nth 0 (sigma_list M)).
Local Notation v0 := (ord_root V : G).

Lemma cycle_of_orbit (x : G) : cycle_of sigma_in (val x) n = map val (fingraph.orbit sigma x).
Proof.
rewrite /fingraph.orbit -/(degree x) /cycle_of.
have dn : degree x <= n by rewrite -[n](card_ord n); exact: max_card.
have step (y : G) : sigma_in (val y) = val (sigma y) by [].
suff H j fuel : j < degree x -> degree x <= fuel + j ->
    cycle_from sigma_in (val x) (val (iter j.+1 sigma x)) fuel
    = [seq val y | y <- traject sigma (iter j.+1 sigma x) (degree x - j.+1)].
  rewrite step (H 0 n) ?degree_gt0 ?addn0 // -[in RHS](prednK (degree_gt0 x)) /=.
  by rewrite subn1.
elim: fuel j => [|fuel IH] j lj le; first by rewrite leqNgt lj in le.
rewrite [cycle_from _ _ _ _]/= -[_ == _]/(iter j.+1 sigma x == x).
move: (lj); rewrite leq_eqVlt => /orP[/eqP E|lt]; first by rewrite E iter_degree eqxx subnn.
case: eqP => [F|_]; first by have := findex_iter lt; rewrite F findex0.
by rewrite step -iterS (IH _ lt) ?addnS -?addSn // -(subnSK lt).
Qed.

Lemma position_tableE (x : G) : nth (0, false) (position_table M) (val x) = position_of v0 x.
Proof.
rewrite (nth_map 0) ?size_iota ?ltn_ord // nth_iota ?ltn_ord // add0n.
rewrite -[root_number M]/(val v0) !cycle_of_orbit size_map size_orbit; congr (_, _).
by rewrite (mem_map val_inj) -fconnect_orbit.
Qed.

Lemma look_on_the_wayE w (x : G) : look_on_the_way w (M, planar_in M, position_table M, val x)
  = percepts_in (M := rooted v0) (position_of v0) w x.
Proof.
elim: w x => [|k w IH] x /=; rewrite /look position_tableE //; congr (_ :: _).
by rewrite /moved -val_turn; exact: (IH (motion k x)).
Qed.
End InNumbers.

(* every map, seen from any dart, is one of the list, under other names *)
Lemma listed_map (G : combinatorial_map) (d : G) :
  exists M, exists (V : valid M) (C : connected (denote M)) (f : G -> in_numbers V C),
  [/\ M \in rooted_maps (edges G), renaming f & f d = ord_root V].
Proof.
pose W := @LighthouseWorld G d d (connect0 _ d).
have [M [k [lM _ [V [C [f [fb fs fa f0 _]]]]]]] := written_down W.
by exists M, V, C, f; split.
Qed.

Section SamePercepts.
Variables (G H : combinatorial_map) (f : G -> H).
Hypothesis F : renaming f.

Lemma same_percepts w d x : percepts_in (M := rooted (f d)) (position_of (f d)) w (f x)
  = percepts_in (M := rooted d) (position_of d) w x.
Proof.
have [fb fs fa] := F; elim: w x => [|k w IH] x /=.
all: rewrite {1}/position_of (same_degree fb fs) (same_at_vertex fb fs) //; congr (_ :: _).
by rewrite -IH; congr (percepts_in _ _ _); rewrite /motion_in /= fa (same_turn fs).
Qed.
End SamePercepts.

Lemma isomorphic_listed (G : combinatorial_map) (d : G) M (V : valid M) (C : connected (denote M))
    (f : G -> in_numbers V C) : renaming f -> isomorphic (rooted d) (denote (seen_from M (val (f d)))).
Proof.
by case=> fb fs fa; apply: isomorphic_trans (same_rooted fb fs fa d) _; exact: numbers_isomorphic.
Qed.

Lemma isomorphic_at_root (G : combinatorial_map) (d : G) M (V : valid M) (C : connected (denote M))
    (f : G -> in_numbers V C) : renaming f -> f d = ord_root V -> isomorphic (rooted d) (denote M).
Proof. by move/(isomorphic_listed d) => I f0; rewrite f0 in I. Qed.

(* ---- Two worlds that a walk does not tell apart ---- *)
Definition walk_alike (G H : combinatorial_map) (d : G) (e : H) w :=
  percepts_in (M := rooted d) (position_of d) w d = percepts_in (M := rooted e) (position_of e) w e.

(* the list has this map in whatever numbering *)
Definition has_map (L : seq numbered_map) (G : combinatorial_map) :=
  forall M (V : valid M) (C : connected (denote M)) (f : G -> in_numbers V C),
  renaming f -> M \in rooted_maps (edges G) -> M \in L.

Definition the_same (M : numbered_map) (_ : bool) (N : numbered_map) (_ : bool) := M == N.
Definition turned N j := seen_from N (iter j (nth 0 (sigma_list N)) (root_number N)).
Definition the_same_at_v0 (M : numbered_map) (planar_M : bool) (N : numbered_map) planar_N :=
  if M == N then true else if ~~ planar_M then true else if ~~ planar_N then true
  else ~~ every (fun j => ~~ same_code M (turned N j)) (iota 0 (degree_at N (root_number N))).

Section TwoWorlds.
Variables (G H : combinatorial_map) (d : G) (e : H) (w : seq nat) (L : seq numbered_map).
Hypotheses (A : walk_alike d e w) (LG : has_map L G) (LH : has_map L H).

Lemma told_apart_worlds same : told_apart same w L ->
  exists M N (VM : valid M) (CM : connected (denote M)) (VN : valid N) (CN : connected (denote N))
    (f : G -> in_numbers VM CM) (g : H -> in_numbers VN CN),
  [/\ same M (planar_in M) N (planar_in N), renaming f /\ f d = ord_root VM & renaming g /\ g e = ord_root VN].
Proof.
move=> T; have [M [VM [CM [f [lM F f0]]]]] := listed_map d.
have [N [VN [CN [g [lN E g0]]]]] := listed_map e.
exists M, N, VM, CM, VN, CN, f, g; split=> //.
apply: (told_apart_sound T); [exact: LG F lM | exact: LH E lN |].
rewrite -[put M]/(M, planar_in M, position_table M, val (ord_root VM : in_numbers VM CM)) look_on_the_wayE.
rewrite -[put N]/(N, planar_in N, position_table N, val (ord_root VN : in_numbers VN CN)) look_on_the_wayE.
by rewrite -f0 -g0 (same_percepts F) (same_percepts E).
Qed.

Theorem the_same_worlds : told_apart the_same w L -> isomorphic (rooted d) (rooted e).
Proof.
case/told_apart_worlds=> M [N [VM [CM [VN [CN [f [g [/eqP MN [F f0] [E g0]]]]]]]]]; subst N.
apply: isomorphic_trans (isomorphic_at_root F f0) _.
exact: isomorphic_sym (rooted_wellformed e) (isomorphic_at_root E g0).
Qed.

Theorem the_same_planar_worlds : planar_map G -> planar_map H ->
  told_apart the_same_at_v0 w L ->
  exists2 e', at_same_vertex e e' & isomorphic (rooted d) (rooted e').
Proof.
move=> pG pH; case/told_apart_worlds=> M [N [VM [CM [VN [CN [f [g [MN [F f0] [E g0]]]]]]]]].
have [[fb fs fa] [gb gs ga]] := (F, E).
have IM := isomorphic_at_root F f0.
have turned_e j : val (g (iter j sigma e)) = root_number (turned N j).
  by rewrite (same_turn gs) g0 val_turn.
have back j : isomorphic (denote (turned N j)) (rooted (iter j sigma e)).
  have := isomorphic_sym (rooted_wellformed _) (isomorphic_listed (iter j sigma e) E).
  by rewrite turned_e.
suff [j I] : exists j, isomorphic (denote M) (denote (turned N j)).
  exists (iter j sigma e); first exact: fconnect_iter.
  exact: isomorphic_trans IM (isomorphic_trans I (back j)).
move: MN; rewrite /the_same_at_v0.
case: eqP => [<- _|_]; first by exists 0; case: (M) => ? ? ?; exact: isomorphic_refl.
rewrite (introT (planar_inP VM CM) ((same_planar fb fs fa).1 pG)).
rewrite (introT (planar_inP VN CN) ((same_planar gb gs ga).1 pH)).
rewrite -[if _ then _ else _]/(~~ every _ _).
rewrite everyE -has_predC => /hasP[j _ /negPn sc]; exists j.
apply: (same_code_sound VM _ sc).
by have := seen_from_valid VN (ltn_ord (g (iter j sigma e))); rewrite turned_e.
Qed.
End TwoWorlds.

(* ---- The lists ---- *)
Definition maps_up_to m := flatten [seq rooted_maps j | j <- iota 1 m].
Definition simple_maps_up_to m := flatten [seq simple_maps j | j <- iota 1 m].

Section UpTo.
Variables (m : nat) (G : combinatorial_map) (d : G).
Hypothesis le : edges G <= m.

Lemma edges_in_range : edges G \in iota 1 m.
Proof.
rewrite mem_iota add1n ltnS le andbT -double_gt0 edges_double.
by apply/card_gt0P; exists d.
Qed.

Lemma all_listed : has_map (maps_up_to m) G.
Proof.
move=> M V C f _ lM; apply/flattenP; exists (rooted_maps (edges G)) => //.
by apply: map_f; exact: edges_in_range.
Qed.

Lemma simple_listed : simple_world G -> has_map (simple_maps_up_to m) G.
Proof.
move=> S M V C f [fb fs fa] lM; apply/flattenP; exists (simple_maps (edges G)).
  by apply: map_f; exact: edges_in_range.
by apply: simple_maps_complete lM _; apply/(simple_in_numbers V C); exact: (same_simple fb fs fa).
Qed.
End UpTo.

(* ---- The walks ---- *)
Definition simple_walk := [:: 1; 1; 1; 1; 1; 1; 1; 2; 1; 1].
(* vm_cast_no_check: the kernel computes it once, when the proof is closed *)
Lemma one_edge_told_apart : told_apart the_same [::] (maps_up_to 1).
Proof. vm_cast_no_check (erefl true). Qed.

Lemma simple_told_apart : told_apart the_same simple_walk (simple_maps_up_to 5).
Proof. vm_cast_no_check (erefl true). Qed.

(* ---- The theorems ---- *)
Section Worlds.
Variables (G H : combinatorial_map) (d : G) (e : H).

Theorem simple_worlds_differ : simple_world G -> simple_world H -> edges G <= 5 -> edges H <= 5 ->
  walk_alike d e simple_walk -> isomorphic (rooted d) (rooted e).
Proof.
move=> SG SH lG lH A; apply: (the_same_worlds A _ _ simple_told_apart).
  exact: (simple_listed d lG SG).
exact: (simple_listed e lH SH).
Qed.

Hypothesis A : look_alike d e.

Theorem no_twins_with_one_edge : edges G <= 1 -> isomorphic (rooted d) (rooted e).
Proof.
move=> lG; have lH := lG; rewrite (alike_edges A) in lH.
by apply: (the_same_worlds (A [::]) _ _ one_edge_told_apart); exact: all_listed.
Qed.

Theorem no_simple_twins : simple_world G -> simple_world H -> edges G <= 5 ->
  isomorphic (rooted d) (rooted e).
Proof.
move=> SG SH lG; have lH := lG; rewrite (alike_edges A) in lH.
exact: simple_worlds_differ (A _).
Qed.
End Worlds.
