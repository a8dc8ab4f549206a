(* ---------------------------------------------------------------------------------------------
   What cannot be explored: cycles, and pairs of worlds that a computation finds indistinguishable.
                                                                                      Section III
   The general theorem is twins_impossible in Indistinguishable.v.  Here, for every explorer:

     cycle_world n t      the cycle of n vertices (a loop for n = 1), seen from a dart of side t:
                          its darts are (vertex, side), the two darts of a vertex have different
                          sides.
     cycles_impossible    cycles of any two lengths, for any percept that is a function of the
                          side: the degree alone (no information), or the degree and a compass
                          (orientation, no position).

     twin_check           a Boolean check of a certificate: two numbered maps, and a list of pairs
                          of darts that is a bisimulation for a given percept.
     certified_impossible every pair that passes the check is a theorem: no explorer is right on
                          both.
     differ_check         a Boolean check that two numbered maps are different maps, wherever rooted.
     no_explorer_maps_both   no explorer finds the maps of the two numbered worlds;
     certified_map_impossible   it is so for every pair that passes both checks.
     generated            the list that the check needs, from the two start darts.
   --------------------------------------------------------------------------------------------- *)
From mathcomp Require Import all_ssreflect.
From Allworlds Require Import Model Maps RootedMaps Codes Explorers Indistinguishable.
From Allworlds Require Import NumberedWorlds.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(* ---- Cycles ---- *)
Definition cycle_sigma (d : nat * bool) := (d.1, ~~ d.2).
Definition cycle_alpha n (d : nat * bool) :=
  (if d.2 then (d.1 + n.-1) %% n else d.1.+1 %% n, ~~ d.2).
Definition cycle_world n t :=
  @RootedMap (nat * bool) (fun d => d.1 < n) cycle_sigma (cycle_alpha n) (0, t).

Lemma cycle_alphaK n d : d.1 < n -> cycle_alpha n (cycle_alpha n d) = d.
Proof.
case: n => // n; case: d => i [] /= l; rewrite /cycle_alpha /= ?negbK; congr (_, _).
  by rewrite -addn1 modnDml -addnA addn1 modnDr modn_small.
by rewrite -addn1 modnDml -addnA add1n modnDr modn_small.
Qed.

Lemma cycle_wellformed n t : 0 < n -> wellformed (cycle_world n t).
Proof.
move=> n0; split=> //=.
- by move=> [i b] /=; rewrite /cycle_alpha /=; case: b; rewrite ltn_mod.
- by move=> [i b] [j c] /= _ _ []; rewrite /cycle_sigma /= => -> /negb_inj->.
- by move=> d; exact: cycle_alphaK.
- by move=> [i []] /= _ [].
Qed.

Lemma cycle_connected n t : 0 < n -> connected (cycle_world n t).
Proof.
move=> n0; rewrite /connected /= => A A0 As Aa [i b] /= li.
suff H j : j < n -> A (j, true) by case: b (H i li) => // /(As (i, true)); apply.
elim: j => [|j IH] lj; first by case: t A0 => // /(As (0, false)); apply.
have lj' := ltnW lj; have := Aa (j, false) lj' (As (j, true) lj' (IH lj')).
by rewrite /cycle_alpha /= modn_small.
Qed.

Lemma same_map_cycles n1 n2 t1 t2 : same_map (cycle_world n1 t1) (cycle_world n2 t2) -> n1 <= n2.
Proof.
move=> [d0 _ [f [g [F G _]]]]; rewrite /= in F G.
pose L n := [seq (i, c) | i <- iota 0 n, c <- [:: false; true]].
have szL n : size (L n) = n * 2 by rewrite size_allpairs size_iota.
have memL n d : (d \in L n) = (d.1 < n).
  apply/allpairsP/idP=> [[[i c] [/= m _ ->]]|l]; first by rewrite mem_iota in m.
  by exists d; rewrite mem_iota !inE; split=> //; case: (d) => ? []; rewrite ?orbT.
have uL n : uniq (L n) by apply: allpairs_uniq; rewrite ?iota_uniq // => -[a c] [a' c'] _ _ [-> ->].
rewrite -(leq_pmul2r (m := 2)) // -!szL -(size_map f); apply: uniq_leq_size.
  rewrite map_inj_in_uniq // => x y; rewrite !memL => lx ly E'.
  by have [_ <- _ _] := F _ lx; have [_ <- _ _] := F _ ly; rewrite E'.
by move=> y /mapP[x]; rewrite memL => /F[? _ _ _] ->; rewrite memL.
Qed.

Section Cycles.
Variables (P : Type) (senses : bool -> P).
Local Notation obs := (fun d : nat * bool => senses d.2).

Theorem cycles_same_episode E (X : explorer P E) n1 n2 t budget :
  (episode X (cycle_world n1 t) obs budget).1 = (episode X (cycle_world n2 t) obs budget).1.
Proof.
apply: (@twins_episode _ _ X (cycle_world n1 t) (cycle_world n2 t) obs obs
  (fun x y => x.2 = y.2)) => //= x y; by rewrite /cycle_sigma /cycle_alpha /= => ->.
Qed.

Theorem cycles_impossible n1 n2 t : 0 < n1 -> 0 < n2 -> n1 <> n2 ->
  @no_explorer_finds_both P (cycle_world n1 t) (cycle_world n2 t) obs obs.
Proof.
move=> p1 p2 ne E meaning X [F1 F2]; case: ne.
have I : same_map (cycle_world n1 t) (cycle_world n2 t).
  apply: (@twins_same_map _ _ meaning X (cycle_world n1 t) (cycle_world n2 t) obs obs
    (fun x y => x.2 = y.2)) F1 F2 => //=; last exact: cycle_wellformed.
  - by move=> x y ->.
  - by move=> x y; rewrite /cycle_sigma /= => ->.
  - by move=> x y; rewrite /cycle_alpha /= => ->.
have J := same_map_sym (cycle_wellformed t p1) (cycle_wellformed t p2) I.
by apply/eqP; rewrite eqn_leq (same_map_cycles I) (same_map_cycles J).
Qed.
End Cycles.

(* every vertex of a cycle has degree 2 *)
Lemma cycle_degree d : cycle_sigma (cycle_sigma d) = d /\ cycle_sigma d <> d.
Proof. by case: d => i []; split. Qed.

(* ---- Certificates ---- *)
Section Certified.
Variables (P : eqType) (senses : numbered_map -> nat -> P).

Definition bisimulation_check M N (L : seq (nat * nat)) :=
  ((root_number M, root_number N) \in L) &&
  all (fun p => [&& senses M p.1 == senses N p.2,
                    (nth 0 (sigma_list M) p.1, nth 0 (sigma_list N) p.2) \in L &
                    (nth 0 (alpha_list M) p.1, nth 0 (alpha_list N) p.2) \in L]) L.

Definition twin_check M N L :=
  [&& valid M, valid N, size (dart_order M) == size (sigma_list M),
      bisimulation_check M N L & ~~ same_code M N].

Section Bisimulation.
Variables (M N : numbered_map) (L : seq (nat * nat)).
Hypothesis C : bisimulation_check M N L.

Lemma certificateE x y : (x, y) \in L ->
  [/\ senses M x = senses N y, (nth 0 (sigma_list M) x, nth 0 (sigma_list N) y) \in L
    & (nth 0 (alpha_list M) x, nth 0 (alpha_list N) y) \in L].
Proof. by case/andP: C => _ /allP H /H /and3P[/eqP]. Qed.

Theorem certified_episode E (X : explorer P E) budget :
  (episode X (denote M) (senses M) budget).1 = (episode X (denote N) (senses N) budget).1.
Proof.
apply: (@twins_episode _ _ X (denote M) (denote N) (senses M) (senses N)
  (fun x y => (x, y) \in L)); try (by move=> x y /certificateE[]); by case/andP: C.
Qed.
End Bisimulation.

(* seen as rooted maps, the place included *)
Theorem certified_impossible M N L : twin_check M N L ->
  forall E (meaning : E -> rooted_map) (X : explorer P E),
  ~ (right meaning X (denote M) (senses M) /\ right meaning X (denote N) (senses N)).
Proof.
case/and5P=> VM VN cM C /negP ns E meaning X [r1 r2]; case: ns; apply: same_code_complete => //.
  exact/connectedP.
apply: (@twins_impossible _ _ meaning X (denote M) (denote N) (senses M) (senses N)
  (fun x y => (x, y) \in L)) => //; try (by move=> x y /(certificateE C)[]); try exact: validP.
by case/andP: C.
Qed.
End Certified.

Definition generated M N :=
  let put p l := if p \in l then l else rcons l p in
  let step p l := put (nth 0 (alpha_list M) p.1, nth 0 (alpha_list N) p.2)
                      (put (nth 0 (sigma_list M) p.1, nth 0 (sigma_list N) p.2) l) in
  let fix go fuel i l :=
    if fuel is fuel'.+1 then
      if i < size l then go fuel' i.+1 (step (nth (0, 0) l i) l) else l
    else l in
  go (size (sigma_list M) * size (sigma_list N)) 0 [:: (root_number M, root_number N)].

(* different wherever they are rooted: different maps, not only different places in one map *)
Definition differ_check M N :=
  [&& valid M, size (dart_order M) == size (sigma_list M) &
      all (fun d => valid (seen_from N d) && ~~ same_code M (seen_from N d))
          (iota 0 (size (sigma_list N)))].

Theorem differ M N : differ_check M N -> ~ same_map (denote M) (denote N).
Proof.
move=> /and3P[VM cM /allP A] [d /= ld I].
have /andP[v /negP ns] := A d (etrans (mem_iota 0 _ d) ld).
by apply: ns; apply: (@same_code_complete M (seen_from N d)) => //; exact/connectedP.
Qed.

Definition no_explorer_maps_both (P : eqType) (senses : numbered_map -> nat -> P) M N :=
  @no_explorer_finds_both P (denote M) (denote N) (senses M) (senses N).
Definition map_twin_check (P : eqType) (senses : numbered_map -> nat -> P) M N L :=
  bisimulation_check senses M N L && differ_check M N.

Theorem certified_map_impossible (P : eqType) (senses : numbered_map -> nat -> P) M N L :
  map_twin_check senses M N L -> no_explorer_maps_both senses M N.
Proof.
move=> /andP[C D] E meaning X [F1 F2]; apply: (differ D); have /and3P[VM _ _] := D.
apply: (@twins_same_map _ _ meaning X (denote M) (denote N) (senses M) (senses N)
  (fun x y => (x, y) \in L)) F1 F2; try (by move=> x y /(certificateE C)[]); last exact: validP.
by case/andP: C.
Qed.
