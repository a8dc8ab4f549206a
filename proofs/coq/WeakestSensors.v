(* ---------------------------------------------------------------------------------------------
   Which of the sensors that tell some of the six features apart (Features.v) suffice: 131 of 203, for all
   worlds, and 24 of them are minimal.

     reasons c            one of the three reasons holds.
     not_rigid_isomorphic   what looks like a world with one edge, or like the path, is that world.
     reasons_suffice      then coarsened c suffices.
   Twins are two worlds that are written down (the door is dart 0, the root is the start):
     different_worlds t   not isomorphic, and degrees do not tell them apart: a bisimulation, computed.
     confused t           the pairs of features that a robot meets at a time as it walks through both.
     twins_refute         if the two of each pair have one letter, the sensor does not suffice.
   A row of a table is six letters, and twins or nothing:
     row_checks           the twins are twins for them, or a reason holds for them.
     table_checks         all rows are so, and all 203 coarsenings (lists of six letters, each the place of the
                          first feature that shows it) have one.
     table_decides        a table that passes proves that the reasons are all there are.
     suffices_iff         such a table, written down by the kernel.
     weakest_iff, rows_counted   those for which a reason holds, and no coarser one: how many there are.
   --------------------------------------------------------------------------------------------- *)
From mathcomp Require Import all_ssreflect.
From Allworlds Require Import Model Maps Percepts RootedMaps Codes Indistinguishable NumberedWorlds.
From Allworlds Require Import Impossibility PositionTwins Ambiguity SameWorld Sensors Features.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Section Suffice.
Variable c : nat -> nat.

Section Both.
Variables W W' : lighthouse_world.
Local Notation cross := (indistinct (percept_by (coarsened c) (W := W)) (percept_by (coarsened c) (W := W'))).

Lemma cross_path x y : cross x y -> path_at x -> path_at y.
Proof.
rewrite /path_at => A /and5P[s1 /eqP s2 s3 s4 /andP[/eqP s5 s6]].
have B := indistinct_alpha A; have T := indistinct_alpha (indistinct_sigma A).
have Z := indistinct_alpha (indistinct_sigma T).
rewrite -(alike_fixed A) -(alike_fixed B) -(alike_fixed T) -(alike_fixed Z) s1 s3 s4 s6.
by rewrite (alike_twice A s2) (alike_twice T s5) !eqxx.
Qed.

Hypothesis I : cross start start.

Lemma cross_some (y : W') : exists x : W, cross x y.
Proof.
apply: (everywhere (A := fun y => exists x : W, cross x y) (d := start)) y => [|y [x A]|y [x A]].
- by exists start.
- by exists (sigma x); exact: indistinct_sigma.
by exists (alpha x); exact: indistinct_alpha.
Qed.
End Both.

Hypothesis ok : reason_apart c.
Local Notation iso W W' := (isomorphic (rooted (@start W)) (rooted (@start W'))).

Lemma not_rigid_isomorphic (W W' : lighthouse_world) : ~ rigid (coarsened c) W ->
  indistinguishable (coarsened c) W W' -> iso W W'.
Proof.
move=> nr /indistinguishable_starts I; have v0 := @pointed_at_v0 W; have v0' := @pointed_at_v0 W'.
case: (rigid_or W ok) => [//|[sr sbb]|[sb sbr]|[P Z DN BD]].
- have E : start = pointed :> W by rewrite at_same_vertex_sym in v0; case/of_two: v0; rewrite ?sr.
  have F : sigma (start : W) = start by rewrite E.
  have F' : sigma (alpha (start : W)) = alpha start by rewrite E.
  apply: edge_isomorphic; left; split=> //; split; apply/eqP; first by rewrite -(alike_fixed I) F.
  by rewrite -(alike_fixed (indistinct_alpha I)) F'.
- have two (G : lighthouse_world) : sigma (@pointed G) = alpha pointed ->
      sigma (alpha (@pointed G)) = pointed ->
      sigma (start : G) = alpha start /\ sigma (alpha (start : G)) = start.
    move=> e e'; have := @pointed_at_v0 G; rewrite at_same_vertex_sym => /of_two[|->|->]; rewrite ?e //.
    by rewrite alphaK.
  have E x : sigma x = alpha x /\ sigma (alpha x) = x :> W.
    pose A x := sigma x = alpha x /\ sigma (alpha x) = x :> W.
    by apply: (everywhere (A := A)) (conj sb sbr) _ _ x => x [e e']; rewrite /A ?e ?alphaK ?e'.
  have E' (y : W') : [/\ c (feature pointed (sigma y)) = c (feature pointed (alpha y)),
      sigma (sigma y) = y & sigma y <> y].
    have [x A] := cross_some I y; have [e e'] := E x; split.
    - by rewrite -(alike_letter (indistinct_sigma A)) -(alike_letter (indistinct_alpha A)) e.
    - by apply: (alike_twice A); rewrite e.
    by apply/eqP; rewrite -(alike_fixed A) e alpha_neq.
  have [L1 T1 F1] := E' pointed; have [L2 T2 F2] := E' (alpha pointed).
  have [sb'|sb'] := sigma (@pointed W') =P alpha pointed.
    apply: edge_isomorphic; right; split; first exact: two.
    by apply: two => //; rewrite -sb'.
  have [vb nbb] := two_next_behind T1 sb' F2; have [br bs] := off_v0 vb.
  rewrite (f_next F1 sb') f_behind in L1; rewrite alphaK f_door in L2.
  case: (@merged_no c ok 5); rewrite /= L1 eqxx andbT -L2.
  case: featureP => [//|//|v _ _ _|v _ _ _|_ _ _ //|_ _ /negP[]] //; by rewrite v in vb.
have at_v0 (G : lighthouse_world) : path_at (@pointed G) -> start = @pointed G \/ start = sigma (@pointed G).
  case/and5P=> _ /eqP s2 _ _ _; apply: of_two => //; rewrite at_same_vertex_sym; exact: pointed_at_v0.
have P' : path_at (@pointed W').
  have [x A] := cross_some I (@pointed W').
  have t := indistinct_sigma Z; have y := indistinct_alpha Z.
  have xP : x \in path_darts pointed by exact: path_all.
  have /and5P[/eqP s1 /eqP s2 /eqP s3 _ /andP[/eqP s5 _]] := P; rewrite s5 in t.
  have sb : sigma (@pointed W) <> alpha pointed by move=> E; move: s3; rewrite -E s2; exact/nesym.
  have Ls := alike_letter t; have Lb := alike_letter y; rewrite f_next // in Ls; rewrite f_behind in Lb.
  move: (alike_letter A) (alike_letter (indistinct_alpha A)); rewrite f_door f_behind.
  move: xP A; rewrite /path_darts !inE; do ! case/orP; move/eqP=> ->;
    rewrite ?alphaK ?(f_next s1 sb) ?f_behind //.
  - by move/cross_path/(_ P).
  - by rewrite -Ls => _ _ ?; congruence.
  - by move=> _ _ ?; congruence.
  - by move/cross_path=> H _ _; apply: H; exact: cross_path Z P.
  by rewrite -Lb => _ ? _; congruence.
have [I1 I2] := paths_isomorphic P P'.
have no (G H : lighthouse_world) : path_at (@pointed G) -> path_at (@pointed H) ->
    indistinct (percept_by (coarsened c) (W := G)) (percept_by (coarsened c) (W := H)) pointed (sigma pointed) ->
    False.
  case/and5P=> _ _ /eqP s3 _ _ /and5P[_ _ _ s4 _] /indistinct_alpha/alike_fixed.
  by rewrite s3 eqxx (negPf s4).
case: (at_v0 W P) (at_v0 W' P') I => -> [->|->] // A; first by case: (no _ _ P P').
case: (no _ _ P P'); have /and5P[_ /eqP s2 _ _ _] := P.
by have := indistinct_sigma A; rewrite s2.
Qed.
End Suffice.

Lemma rigid_or_not (A : eqType) (lambda : sensor A) (W : lighthouse_world) :
  rigid lambda W \/ ~ rigid lambda W.
Proof.
pose alike := indistinct (percept_by lambda (W := W)) (percept_by lambda (W := W)).
have [R|R] := boolP [forall x, forall y, alike x y ==> (x == y)]; [left|right].
  by move=> x y; move/forallP/(_ x)/forallP/(_ y)/implyP: R => H /H /eqP.
by move=> H; case/negP: R; apply/forallP=> x; apply/forallP=> y; apply/implyP=> /H ->.
Qed.

Lemma indistinguishable_sym (A : Type) (lambda : sensor A) (W W' : lighthouse_world) :
  indistinguishable lambda W W' -> indistinguishable lambda W' W.
Proof.
case=> R [Ro Rs Ra R0]; exists (fun y x => R x y).
by split=> // y x; [move/Ro | exact: Rs | exact: Ra].
Qed.

Definition reasons c := [|| reason_behind c, reason_edge c | reason_apart c].

Theorem reasons_suffice c : reasons c -> sufficient (coarsened c).
Proof.
case/or3P=> [H|H|H] W W' I.
- by apply: rigid_isomorphic I; exact: behind_rigid.
- by apply: rigid_isomorphic I; exact: edge_rigid.
have [R|R] := rigid_or_not (coarsened c) W; last exact: (not_rigid_isomorphic H).
have [R'|R'] := rigid_or_not (coarsened c) W'; first exact: rigid_isomorphic I.
apply: isomorphic_sym; first exact: rooted_wellformed.
by apply: (not_rigid_isomorphic H R'); exact: indistinguishable_sym.
Qed.

(* ---- Twins, by computation ---- *)
Definition place M :=
  find (fun k => iter k (nth 0 (sigma_list M)) (root_number M) == 0) (iota 0 (size (sigma_list M))).
Definition feature_in M x :=
  let s := nth 0 (sigma_list M) in let a := nth 0 (alpha_list M) in
  let r := iter (place M) s (root_number M) in let home y := isSome (sensed M r y).2 in
  if x == r then 3 else if x == a r then 2 else if home x then if x == s r then 4 else 5
  else has (fun k => home (a (iter k s x))) (iota 0 (size (sigma_list M))).

Section InNumbers.
Variable M : numbered_map.
Hypotheses (V : valid M) (C : connected (denote M)).
Local Notation W := (world_of_numbers V C (place M)).
Local Notation r := (iter (place M) (nth 0 (sigma_list M)) (root_number M)).

Lemma feature_in_numbers (i : W) : feature_in M (val i) = feature pointed i.
Proof.
have P : r = val (@pointed W) by rewrite val_turn.
have home (x : W) : isSome (sensed M (val (@pointed W)) (val x)).2 = at_same_vertex x pointed.
  by rewrite -P sensed_percept /percept_of /bearing; case: ifP.
rewrite /feature_in P home /feature -[nth 0 (alpha_list M) _]/(val (alpha (@pointed W))).
rewrite -[nth 0 (sigma_list M) _]/(val (sigma (@pointed W))) !(inj_eq val_inj).
do 3 case: ifP => // _; congr nat_of_bool; apply/hasP/existsP=> [[k _]|[y /andP[v h]]].
  rewrite -val_turn -[nth 0 (alpha_list M) _]/(val (alpha (iter k sigma i))) home => h.
  by exists (iter k sigma i); rewrite h andbT /at_same_vertex fconnect_iter.
exists (findex sigma i y); last first.
  by rewrite -val_turn iter_findex // -[nth 0 (alpha_list M) _]/(val (alpha y)) home.
rewrite mem_iota; apply: leq_trans (findex_max v) _.
by rewrite -[X in _ <= X](card_ord (size (sigma_list M))) max_card.
Qed.

Lemma degree_in_numbers (i : W) : degree_at M (val i) = degree i.
Proof. by rewrite -[LHS]/(sensed M r (val i)).1 sensed_percept. Qed.
End InNumbers.

Definition different_worlds (t : numbered_map * numbered_map) :=
  twin_check degree_at t.1 t.2 (generated t.1 t.2) && (size (dart_order t.2) == size (sigma_list t.2)).
Definition confused (t : numbered_map * numbered_map) :=
  undup [seq (feature_in t.1 p.1, feature_in t.2 p.2) | p <- generated t.1 t.2].
Definition merges (l : seq (nat * nat)) c := all (fun q => c q.1 == c q.2 :> nat) l.

Theorem twins_refute t c : different_worlds t -> merges (confused t) c -> ~ sufficient (coarsened c).
Proof.
case: t => M N /= /andP[/and5P[VM VN /(connectedP VM) CM K /negP no] /(connectedP VN) CN] /allP L S.
have E := certificateE K; have /andP[K0 _] := K; apply: no; apply: same_code_complete => //.
pose W := world_of_numbers VM CM (place M); pose W' := world_of_numbers VN CN (place N).
have I : isomorphic (rooted (@start W)) (rooted (@start W')).
  apply: S; exists (fun x y => (val x, val y) \in generated M N).
  split=> //; move=> x y m; have [D s a] := E _ _ m => //.
  have := L (feature pointed x, feature pointed y); rewrite mem_undup -!feature_in_numbers.
  rewrite /percept_by -!degree_in_numbers D => /(_ (map_f _ m)) /eqP e.
  by rewrite /coarsened -!feature_in_numbers e.
have J := isomorphic_sym (rooted_wellformed _) (numbers_isomorphic (@start W)).
exact: isomorphic_trans J (isomorphic_trans I (numbers_isomorphic (@start W'))).
Qed.

Definition twins := [::
  (NumberedMap [:: 1; 0] [:: 1; 0] 0, NumberedMap [:: 1; 0; 3; 2] [:: 2; 3; 0; 1] 0);
  (NumberedMap [:: 1; 2; 3; 0] [:: 1; 0; 3; 2] 0, NumberedMap [:: 1; 2; 3; 0] [:: 1; 0; 3; 2] 3);
  (NumberedMap [:: 1; 3; 2; 0] [:: 2; 3; 0; 1] 0,
   NumberedMap [:: 1; 3; 2; 0; 6; 4; 5; 7] [:: 2; 4; 0; 5; 1; 3; 7; 6] 0);
  (NumberedMap [:: 1; 3; 4; 2; 5; 0] [:: 2; 3; 0; 1; 5; 4] 0,
   NumberedMap [:: 1; 3; 5; 2; 0; 4] [:: 2; 4; 0; 5; 1; 3] 0);
  (NumberedMap [:: 0; 2; 3; 4; 5; 7; 6; 1] [:: 1; 0; 3; 2; 6; 7; 4; 5] 0,
   NumberedMap [:: 0; 2; 3; 5; 1; 6; 4; 7] [:: 1; 0; 4; 6; 2; 7; 3; 5] 0);
  (NumberedMap [:: 1; 0; 4; 5; 6; 7; 2; 3] [:: 2; 3; 0; 1; 6; 7; 4; 5] 0,
   NumberedMap [:: 1; 0; 4; 5; 6; 7; 2; 3] [:: 2; 3; 0; 1; 7; 6; 5; 4] 0);
  (NumberedMap [:: 1; 3; 5; 6; 2; 7; 4; 0] [:: 2; 4; 0; 6; 1; 7; 3; 5] 2,
   NumberedMap [:: 1; 3; 5; 6; 2; 7; 4; 0] [:: 2; 4; 0; 7; 1; 6; 5; 3] 2);
  (NumberedMap [:: 1; 0; 3; 2; 5; 6; 7; 8; 9; 4] [:: 2; 4; 0; 7; 1; 6; 5; 3; 9; 8] 0,
   NumberedMap [:: 1; 0; 3; 2; 5; 6; 7; 8; 9; 4] [:: 2; 4; 0; 7; 1; 9; 8; 3; 6; 5] 0);
  (NumberedMap [:: 1; 0; 2; 4; 5; 6; 7; 9; 10; 3; 8; 11] [:: 2; 3; 0; 1; 5; 4; 8; 9; 6; 7; 11; 10] 0,
   NumberedMap [:: 1; 0; 2; 4; 5; 7; 3; 8; 6; 10; 9; 11] [:: 2; 3; 0; 1; 6; 8; 4; 9; 5; 7; 11; 10] 0);
  (NumberedMap [:: 1; 3; 5; 0; 6; 7; 8; 2; 9; 10; 11; 4] [:: 2; 4; 0; 5; 1; 3; 8; 9; 6; 7; 11; 10] 3,
   NumberedMap [:: 1; 3; 5; 0; 6; 7; 8; 2; 10; 4; 11; 9] [:: 2; 4; 0; 5; 1; 3; 9; 10; 11; 6; 7; 8] 3)].

(* ---- All coarsenings ---- *)
Fixpoint growing n := if n is n'.+1 then [seq rcons u x | u <- growing n', x <- iota 0 n] else [:: [::]].
Definition canonical (u : seq nat) := [seq index x u | x <- u].
Definition coarsenings := undup [seq canonical u | u <- growing 6].
Definition same_letters (c c' : nat -> nat) := forall i j, i < 6 -> j < 6 -> (c i == c j) = (c' i == c' j).

Lemma growing_complete n u : size u = n -> (forall i, i < n -> nth 0 u i <= i) -> u \in growing n.
Proof.
elim: n u => [|n IH] u; first by move/size0nil ->.
case/lastP: u => // u x; rewrite size_rcons => -[s] le; apply/allpairsP; exists (u, x); split=> //.
  by apply: IH => // i li; have := le i (ltnW li); rewrite nth_rcons s li.
by rewrite mem_iota /=; have := le n (leqnn _); rewrite nth_rcons s ltnn eqxx.
Qed.

Lemma index_least (u : seq nat) i j : i < size u -> nth 0 u i = nth 0 u j -> index (nth 0 u j) u <= i.
Proof. by move=> li E; rewrite leqNgt; apply/negP=> /(before_find 0); rewrite /= E eqxx. Qed.

Lemma canonical_same u : size u = 6 -> same_letters (nth 0 u) (nth 0 (canonical u)).
Proof.
move=> s i j li lj; rewrite !(nth_map 0) ?s //; apply/eqP/eqP=> [-> //|E].
have back k : k < 6 -> nth 0 u (index (nth 0 u k) u) = nth 0 u k.
  by move=> lk; rewrite nth_index // mem_nth ?s.
by rewrite -(back i) // E back.
Qed.

Lemma coarsening_of c : exists2 u, u \in coarsenings & same_letters c (nth 0 u).
Proof.
set u := mkseq c 6; have s : size u = 6 by rewrite size_mkseq.
exists (canonical (canonical u)).
  rewrite mem_undup map_f // growing_complete ?size_map // => i li.
  by rewrite (nth_map 0) ?s //; apply: index_least; rewrite ?s.
move=> i j li lj; rewrite -!(canonical_same (u := canonical u)) ?size_map // -!(canonical_same s) //.
by rewrite !nth_mkseq.
Qed.

Lemma same_sufficient c c' : same_letters c c' -> sufficient (coarsened c) -> sufficient (coarsened c').
Proof. by move=> E; apply/sufficient_finer/coarsened_coarser=> i j li lj /eqP; rewrite -E // => /eqP. Qed.

Lemma same_reasons c c' : same_letters c c' -> reasons c = reasons c'.
Proof. by move=> E; rewrite /reasons /reason_behind /reason_edge /reason_apart /merged /= !inE !E. Qed.

(* ---- A table ---- *)
Definition row := (seq nat * option (numbered_map * numbered_map))%type.
Definition row_checks (t : row) :=
  if t.2 is Some p then different_worlds p && merges (confused p) (nth 0 t.1) else reasons (nth 0 t.1).
Definition table_checks (T : seq row) := all row_checks T && all (fun u => u \in unzip1 T) coarsenings.

Lemma row_sound t : row_checks t ->
  if t.2 is Some _ then ~ sufficient (coarsened (nth 0 t.1)) else sufficient (coarsened (nth 0 t.1)).
Proof. by case: t => u [p|] /=; [case/andP; exact: twins_refute | exact: reasons_suffice]. Qed.

Theorem table_decides T c : table_checks T -> sufficient (coarsened c) <-> reasons c.
Proof.
case/andP=> /(all_nthP ([::], None)) R /allP A; split; last exact: reasons_suffice.
have [u cu E] := coarsening_of c; move/(same_sufficient E); rewrite (same_reasons E).
have /(nthP [::])[i] := A u cu; rewrite size_map => li; rewrite (nth_map ([::], None)) // => <-.
by case: (nth _ _ _) (R i li) => v [p|] //= /row_sound.
Qed.

Definition table_of twins : seq row :=
  let ts := [seq (t, confused t) | t <- twins] in
  [seq (u, if reasons (nth 0 u) then None else ohead [seq t.1 | t <- ts & merges t.2 (nth 0 u)])
    | u <- coarsenings].

Lemma table_checked : table_checks (table_of twins).
Proof. by vm_compute. Qed.

Theorem suffices_iff c : sufficient (coarsened c) <-> reasons c.
Proof. exact: table_decides table_checked. Qed.

(* ---- 131, and 24 ---- *)
Definition tells_less (c c' : nat -> nat) := forall i j, i < 6 -> j < 6 -> c i = c j -> c' i = c' j.
Definition sufficing := [seq u <- coarsenings | reasons (nth 0 u)].
Definition coarser_row (c : nat -> nat) v := all (fun i => c i == c (nth 0 v i)) (iota 0 6).
Definition weakest :=
  [seq u <- sufficing | all (fun v => coarser_row (nth 0 v) u ==> coarser_row (nth 0 u) v) sufficing].

Lemma coarsenings_canonical : all (fun u =>
  all (fun i => (nth 0 u i < 6) && (nth 0 u (nth 0 u i) == nth 0 u i)) (iota 0 6)) coarsenings.
Proof. by vm_compute. Qed.

Lemma coarser_rowP c u : u \in coarsenings -> reflect (tells_less (nth 0 u) c) (coarser_row c u).
Proof.
move=> cu; have /allP/(_ u cu)/allP K := coarsenings_canonical.
have {}K i : i < 6 -> nth 0 u i < 6 /\ nth 0 u (nth 0 u i) = nth 0 u i.
  by move=> li; have /andP[l /eqP] := K i (etrans (mem_iota 0 6 i) li).
apply: (iffP allP) => [H i j li lj E|H i]; last first.
  by rewrite mem_iota => li; have [l e] := K i li; apply/eqP/H; rewrite // e.
have /eqP -> := H i (etrans (mem_iota 0 6 i) li); rewrite E.
by have /eqP <- := H j (etrans (mem_iota 0 6 j) lj).
Qed.

Lemma listed_once : all (fun u => all (fun v =>
  coarser_row (nth 0 u) v && coarser_row (nth 0 v) u ==> (u == v)) coarsenings) coarsenings.
Proof. by vm_compute. Qed.

Lemma coarsenings_differ u v : u \in coarsenings -> v \in coarsenings ->
  same_letters (nth 0 u) (nth 0 v) -> u = v.
Proof.
move=> cu cv E; have /allP/(_ v cv)/implyP H := allP listed_once u cu; apply/eqP/H.
apply/andP; split; [apply/(coarser_rowP _ cv) | apply/(coarser_rowP _ cu)] => i j li lj /eqP.
  by rewrite -(E i j li lj) => /eqP.
by rewrite (E i j li lj) => /eqP.
Qed.

Theorem weakest_iff u : u \in coarsenings -> u \in weakest <-> sufficient (coarsened (nth 0 u)) /\
  forall c, tells_less (nth 0 u) c -> sufficient (coarsened c) -> tells_less c (nth 0 u).
Proof.
move=> cu; rewrite !mem_filter cu andbT andbC; split=> [/andP[/suffices_iff S /allP H]|[/suffices_iff -> H]].
  split=> // c L Sc; have [v cv E] := coarsening_of c.
  have vs : v \in sufficing by rewrite mem_filter cv andbT -(same_reasons E); exact/suffices_iff.
  have /(coarser_rowP _ cv) V : coarser_row (nth 0 u) v.
    have Lv : tells_less (nth 0 u) (nth 0 v).
      by move=> i j li lj /(L i j li lj)/eqP; rewrite (E i j li lj) => /eqP.
    by move/implyP: (H v vs); apply; apply/(coarser_rowP _ cu).
  by move=> i j li lj /eqP; rewrite (E i j li lj) => /eqP; exact: V.
apply/allP=> v; rewrite mem_filter => /andP[/suffices_iff S cv]; apply/implyP=> /(coarser_rowP _ cu) L.
by apply/(coarser_rowP _ cv); exact: H.
Qed.

Theorem rows_counted : [/\ size coarsenings = 203, size sufficing = 131 & size weakest = 24].
Proof. by split; vm_compute. Qed.

Theorem each_once : [/\ uniq coarsenings, forall c, exists2 u, u \in coarsenings & same_letters c (nth 0 u) &
  forall u v, u \in coarsenings -> v \in coarsenings -> same_letters (nth 0 u) (nth 0 v) -> u = v].
Proof. by split; [exact: undup_uniq | exact: coarsening_of | exact: coarsenings_differ]. Qed.

Theorem sufficing_iff u : u \in coarsenings -> u \in sufficing <-> sufficient (coarsened (nth 0 u)).
Proof. by move=> cu; rewrite mem_filter cu andbT; exact: iff_sym (suffices_iff _). Qed.
