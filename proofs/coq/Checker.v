(* ---------------------------------------------------------------------------------------------
   The checker: is an explorer right, and within so many motions, in every world with at most m edges?

   It enumerates the worlds (Enumeration.v), runs the explorer in each and judges its answer (Judge.v).
   The theorem is check_correct: `check` says true if and only if the explorer is right within its limit
   in every such world, under whatever names its darts go.  The explorer may be any function of the
   percepts so far.  Without a limit on its motions the question could not be decided.

     right_within X M senses limit   X stops after at most `limit` motions, and its answer is right.

     resumption           an explorer that keeps a state: `begins` makes it of the first percept, `decides`
                          says what to do, `goes_on` takes in what is sensed next.
     as_explorer r        the explorer, a function of the percepts so far, that r is.
     remembering X        any explorer as a resumption: its state is the percepts so far.
     episode_of           a whole run of r: Explorers.episode, step by step.

     kind of lighthouse   `sees` what is sensed in a world and `kind` which worlds are meant; `senses`
                          and `admits` the same, computed, for worlds written as lists of numbers: a
                          numbered map, and how many darts clockwise of its root the marker points.
     worlds m             these worlds, with m edges.
     examine w            what comes out in world w: no answer within the limit, or the verdict.
     refutations m        the worlds with m edges in which it is not right.
     check m              there are none with 1 to m edges.

     check_correct        check m, if and only if the explorer is right within the limit in every world
                          of this kind with at most m edges.
     refutation_correct   each world in refutations m is of this kind, has m edges, and the explorer is
                          not right in it within the limit.

     directional          the lighthouse of the paper, every bearing; u: all worlds, or the simple ones.
     paper_limit          (1)+(2), computed.
     algorithm1_checked   Algorithm 1 passes, under every policy, for every m.
   --------------------------------------------------------------------------------------------- *)
From mathcomp Require Import all_ssreflect.
From Allworlds Require Import Model Maps RootedMaps Codes Explorers NumberedWorlds Judge Enumeration.
From Allworlds Require Import Cost Algorithm Refinement Twins Cluster SameWorld.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(* ---- Right, within so many motions ---- *)
Section RightWithin.
Variables (O : Type) (X : explorer O numbered_map).

Definition right_within (M : rooted_map) (senses : carrier M -> O) limit :=
  exists budget transcript answer z,
  [/\ episode X M senses budget = (transcript, Some answer, z), size transcript <= limit,
      valid answer & isomorphic (denote answer) (rooted_at M z)].

Lemma explore_size (M : rooted_map) (senses : carrier M -> O) fuel seen d :
  size (explore X M senses fuel seen d).1.1 <= fuel.
Proof.
elim: fuel seen d => [|fuel IH] seen d /=; case: (X seen) => // k.
by have := IH (rcons seen (senses (motion_in M k d))) (motion_in M k d); case: explore => [[t a] z].
Qed.

(* a budget of as many motions as it makes is enough *)
Lemma explore_enough (M : rooted_map) (senses : carrier M -> O) fuel seen d t e z :
  explore X M senses fuel seen d = (t, Some e, z) ->
  explore X M senses (size t) seen d = (t, Some e, z).
Proof.
elim: fuel seen d t => [|fuel IH] seen d t /=; case E: (X seen) => [k|a] //.
- by case=> <- <- <- /=; rewrite E.
- case R: (explore _ _ _ _ _ _) => [[t' a'] z'] [<- A Z]; subst a' z'.
  by rewrite /= E (IH _ _ _ R).
by case=> <- <- <- /=; rewrite E.
Qed.

Lemma right_withinE (M : rooted_map) (senses : carrier M -> O) limit :
  right_within senses limit <-> exists transcript answer z,
  [/\ episode X M senses limit = (transcript, Some answer, z),
      valid answer & isomorphic (denote answer) (rooted_at M z)].
Proof.
split=> [[b [t [e [z [R s V I]]]]]|[t [e [z [R V I]]]]]; last first.
  exists limit, t, e, z; split=> //.
  by have := explore_size senses limit [:: senses (root M)] (root M); rewrite -/(episode _ _ _ _) R.
by exists t, e, z; split=> //; rewrite -(subnKC s); apply/explore_more/(explore_enough R).
Qed.
End RightWithin.

(* explorers that agree wherever something has been sensed *)
Lemma episode_eq O E (X Y : explorer O E) (M : rooted_map) (senses : carrier M -> O) budget :
  (forall o s, X (o :: s) = Y (o :: s)) -> episode X M senses budget = episode Y M senses budget.
Proof.
move=> XY; suff H o s d : explore X M senses budget (o :: s) d = explore Y M senses budget (o :: s) d.
  exact: H.
by elim: budget s d => [|n IH] s d /=; rewrite XY //; case: (Y _) => // k; rewrite IH.
Qed.

(* ---- Explorers that keep a state ---- *)
Record resumption (S O : Type) := Resumption {
  begins : O -> S;
  decides : S -> action numbered_map;
  goes_on : S -> O -> S }.

Section Resumptions.
Variables (S O : Type) (r : resumption S O).

Definition as_explorer : explorer O numbered_map := fun seen =>
  if seen is o :: seen' then decides r (foldl (goes_on r) (begins r o) seen') else Move 0.

Section Run.
Variables (D : Type) (moves : nat -> D -> D) (senses : D -> O).
Fixpoint run_from fuel s d : seq (nat * O) * option numbered_map * D :=
  match decides r s with
  | Stop answer => ([::], Some answer, d)
  | Move k =>
      if fuel is fuel'.+1 then
        let d' := moves k d in
        let: (transcript, answer, z) := run_from fuel' (goes_on r s (senses d')) d' in
        ((k, senses d') :: transcript, answer, z)
      else ([::], None, d)
  end.

(* the same, in constant space: taken, the steps so far, the last one first *)
Fixpoint run_onto taken fuel s d : seq (nat * O) * option numbered_map * D :=
  match decides r s with
  | Stop answer => (rev taken, Some answer, d)
  | Move k =>
      if fuel is fuel'.+1 then
        let d' := moves k d in
        run_onto ((k, senses d') :: taken) fuel' (goes_on r s (senses d')) d'
      else (rev taken, None, d)
  end.
Definition episode_of fuel d := run_onto [::] fuel (begins r (senses d)) d.

Lemma run_ontoE taken fuel s d : run_onto taken fuel s d =
  let: (transcript, answer, z) := run_from fuel s d in (catrev taken transcript, answer, z).
Proof.
elim: fuel taken s d => [|fuel IH] taken s d /=; case: (decides r s) => // k.
by rewrite IH; case: (run_from _ _ _) => [[t a] z].
Qed.

Lemma episode_ofE fuel d : episode_of fuel d = run_from fuel (begins r (senses d)) d.
Proof. by rewrite /episode_of run_ontoE; case: (run_from _ _ _) => [[t a] z]. Qed.
End Run.

Lemma explore_run (M : rooted_map) (senses : carrier M -> O) fuel o seen d :
  explore as_explorer M senses fuel (o :: seen) d
  = run_from (motion_in M) senses fuel (foldl (goes_on r) (begins r o) seen) d.
Proof.
elim: fuel seen d => [|fuel IH] seen d /=; case: (decides r _) => // k.
by rewrite IH -cats1 foldl_cat.
Qed.

Theorem episode_resumption (M : rooted_map) (senses : carrier M -> O) fuel :
  episode as_explorer M senses fuel = episode_of (motion_in M) senses fuel (root M).
Proof. by rewrite episode_ofE; exact: explore_run. Qed.
End Resumptions.

Definition remembering O (X : explorer O numbered_map) : resumption (seq O) O :=
  Resumption (fun o => [:: o]) X rcons.

Lemma as_remembering O (X : explorer O numbered_map) o seen :
  as_explorer (remembering X) (o :: seen) = X (o :: seen).
Proof.
rewrite /= -[o :: seen]/([:: o] ++ seen); congr X.
elim: seen [:: o] => [|a s IH] l /=; first by rewrite cats0.
by rewrite IH -cats1 -catA.
Qed.

(* ---- The checker ---- *)
Inductive finding := NoAnswer | Judged (v : verdict).
Definition is_right f := if f is Judged IsRight then true else false.

Section Program.
Variables (S O : Type) (r : resumption S O) (limit : nat -> nat -> nat -> nat).
Variables (senses : numbered_map -> nat -> nat -> O) (admits : numbered_map -> nat -> bool).

Definition worlds m :=
  [seq w <- flatten [seq [seq (M, k) | k <- iota 0 (degree_at M (root_number M))]
                    | M <- rooted_maps m] | admits w.1 w.2].

(* what is sensed in each dart, computed once *)
Definition look_up (w : numbered_map * nat) : nat -> O :=
  if [seq senses w.1 w.2 d | d <- iota 0 (size (sigma_list w.1))] is o :: os
  then nth o (o :: os) else senses w.1 w.2.

Definition run_in (w : numbered_map * nat) : seq (nat * O) * option numbered_map * nat :=
  let M := w.1 in
  let most := limit (vertices_in M) (edges_in M) (degree_at M (root_number M)) in
  episode_of r (motion_in (denote M)) (look_up w) most (root_number M).

Definition examine w :=
  let: (_, answer, z) := run_in w in
  if answer is Some e then Judged (judge w.1 z e) else NoAnswer.
Definition refutations m := [seq w <- worlds m | ~~ is_right (examine w)].
Definition check m := all (fun j => nilp (refutations j)) (iota 1 m).

(* ---- What it says is so ---- *)
Variables (sees : forall W : lighthouse_world, W -> O) (kind : lighthouse_world -> Prop).
Hypothesis sees_same : forall (W V : lighthouse_world) (f : W -> V), same_world f ->
  forall d, sees (f d) = sees d.
Hypothesis kind_same : forall (W V : lighthouse_world) (f : W -> V), same_world f ->
  kind W -> kind V.
Hypothesis senses_sees : forall M (V : valid M) (C : connected (denote M)) k
  (i : world_of_numbers V C k), senses M k (val i) = sees i.
Hypothesis admits_kind : forall M (V : valid M) (C : connected (denote M)) k,
  reflect (kind (world_of_numbers V C k)) (admits M k).

Local Notation X := (as_explorer r).
Local Notation limit_in W := (limit (vertices W) (edges W) (degree (@start W))).
Local Notation right_in W :=
  (right_within X (M := rooted (@start W)) (@sees W) (limit_in W)).

Lemma right_same (W V : lighthouse_world) (f : W -> V) : same_world f -> right_in V -> right_in W.
Proof.
move=> F; have [fb fs fa f0 _] := F; case/right_withinE=> t [e [z [R Ve I]]]; apply/right_withinE.
have [||||E1 E2] := @related_episode _ _ X (rooted (@start W)) (rooted (@start V)) (@sees W) (@sees V)
  (fun x y => y = f x) _ _ _ _ (limit_in V) => //=.
- by move=> x _ ->; rewrite (sees_same F).
- by move=> x _ ->.
- by move=> x _ ->.
have -> : limit_in W = limit_in V.
  by rewrite (same_vertices fb fs) (same_edges fb) -f0 (same_degree fb fs).
rewrite R in E1 E2.
move: E1 E2; case: (episode _ _ _ _) => [[t' a'] z'] /= [-> ->] zE.
exists t, e, z'; split=> //; rewrite zE in I; apply: isomorphic_trans I _.
by apply: isomorphic_sym (rooted_wellformed _) _; exact: same_rooted.
Qed.

Section OneWorld.
Variables (M : numbered_map) (V : valid M) (C : connected (denote M)) (k : nat).
Local Notation W := (world_of_numbers V C k).

Lemma look_upE d : d < size (sigma_list M) -> look_up (M, k) d = senses M k d.
Proof.
rewrite /look_up /=; case E: [seq _ | _ <- _] => [|o os] // ld.
by rewrite -E (nth_map 0) ?size_iota // nth_iota.
Qed.

Lemma run_in_episode : let: (t, a, z) := run_in (M, k) in
  (episode X (rooted (@start W)) (@sees W) (limit_in W)).1 = (t, a) /\
  val (episode X (rooted (@start W)) (@sees W) (limit_in W)).2 = z.
Proof.
rewrite /run_in -(vertices_in_numbers V C) -(edges_in_numbers V C).
rewrite -[root_number M]/(val (@start W)) (@degree_in_numbers M V C (@start W)) -episode_resumption.
have [||||] := @related_episode _ _ X (denote M) (rooted (@start W)) (look_up (M, k)) (@sees W)
  (fun i j => i = val j) _ _ _ _ (limit_in W) => //=.
- by move=> i j ->; rewrite -senses_sees look_upE.
- by move=> i j ->.
- by move=> i j ->.
by case: (episode _ (denote M) _ _) => [[t a] z] /= <- <-.
Qed.

Lemma examine_right : is_right (examine (M, k)) <-> right_in W.
Proof.
have := run_in_episode; rewrite /examine; case: (run_in _) => [[t a] z].
case E: (episode _ _ _ _) => [[t' a'] z'] /= [[T A] Z]; subst t' a' z.
have lz := ltn_ord z'; have I' := @numbers_isomorphic M V C z'.
have Vz := seen_from_valid V lz; have Cz := seen_from_connected V C lz.
split=> [|/right_withinE [t1 [e [z1]]]]; last first.
  rewrite E => -[[_ -> <-] Ve I]; suff -> : judge M (val z') e = IsRight by [].
  rewrite /judge Ve /=; suff -> : same_code (seen_from M (val z')) e by [].
  apply/(judgeP V C Ve lz)/(isomorphic_sym (validP Ve)). exact: (isomorphic_trans I I').
case: a E => // e E; case J: (judge _ _ _) => // _; apply/right_withinE; exists t, e, z'; split=> //.
  by move: J; rewrite /judge; case: (valid e).
have Ve : valid e by move: J; rewrite /judge; case: (valid e).
move: J; rewrite /judge Ve /=; case: (judgeP V C Ve lz) => // [I _|_]; last by case: ifP.
apply: isomorphic_trans (isomorphic_sym (validP Vz) I) _.
exact: isomorphic_sym (rooted_wellformed _) I'.
Qed.
End OneWorld.

Lemma worldsP m M k : (M, k) \in worlds m =
  [&& M \in rooted_maps m, k < degree_at M (root_number M) & admits M k].
Proof.
rewrite mem_filter andbC andbA; congr (_ && _); apply/flattenP/andP=> [[s]|[lM lk]].
  by case/mapP=> M' lM -> /mapP[k' lk [-> ->]]; rewrite mem_iota in lk.
by eexists; [apply: map_f lM | apply: map_f; rewrite mem_iota].
Qed.

Lemma edges_of_listed m M (V : valid M) (C : connected (denote M)) : M \in rooted_maps m ->
  edges (in_numbers V C) = m.
Proof. by move=> lM; have [_ _ s] := rooted_maps_sound lM; rewrite edges_in_numbers /edges_in s doubleK. Qed.

Theorem refutation_correct m M k : (M, k) \in refutations m ->
  exists (V : valid M) (C : connected (denote M)),
  [/\ kind (world_of_numbers V C k), edges (world_of_numbers V C k) = m &
      ~ right_in (world_of_numbers V C k)].
Proof.
rewrite mem_filter worldsP => /andP[N /and3P[lM _ A]]; have [V C _] := rooted_maps_sound lM.
exists V, C; split; [exact/admits_kind | exact: edges_of_listed | ].
by move/(examine_right V C k).2; exact/negP.
Qed.

Theorem check_correct m : check m <-> forall W, kind W -> edges W <= m -> right_in W.
Proof.
split=> [/allP H W kW le|H].
  have [M [k [lM lk [V [C [f F]]]]]] := written_down W; apply: (right_same F).
  apply/(examine_right V C k)/negPn/negP=> N.
  have := H (edges W); rewrite mem_iota add1n ltnS le andbT => /(_ _)/nilP R.
  have : (M, k) \in refutations (edges W).
    by rewrite mem_filter N worldsP lM lk; apply/(admits_kind V C); exact: (kind_same F).
  rewrite R // -double_gt0 (edges_double W); apply/card_gt0P; by exists start.
apply/allP=> j; rewrite mem_iota add1n ltnS => /andP[_ lj]; apply/nilP.
case E: (refutations j) => [//|[M k] s]; have := mem_head (M, k) s; rewrite -E.
by case/refutation_correct=> V [C [kW Ej []]]; apply: H => //; rewrite Ej.
Qed.
End Program.

(* ---- With a directional lighthouse ---- *)
Definition directional_senses M k := sensed M (iter k (nth 0 (sigma_list M)) (root_number M)).
Definition in_universe_in u M (k : nat) := if u is SimpleWorlds then simple M else true.

Definition directional_check S (r : resumption S percept) limit u :=
  check r limit directional_senses (in_universe_in u).
Definition directional_refutations S (r : resumption S percept) limit u :=
  refutations r limit directional_senses (in_universe_in u).

Section Directional.
Variables (S : Type) (r : resumption S percept) (limit : nat -> nat -> nat -> nat) (u : universe).
Local Notation right_in W := (right_within (as_explorer r) (M := rooted (@start W)) (@percept_of W)
  (limit (vertices W) (edges W) (degree (@start W)))).

Lemma directional_senses_percept M (V : valid M) (C : connected (denote M)) k
  (i : world_of_numbers V C k) : directional_senses M k (val i) = percept_of i.
Proof. exact: sensed_percept. Qed.

Lemma in_universe_same (W V : lighthouse_world) (f : W -> V) : same_world f ->
  in_universe u W -> in_universe u V.
Proof. by case: u => // -[fb fs fa _ _]; exact: (same_simple fb fs fa). Qed.

Lemma in_universe_numbers M (V : valid M) (C : connected (denote M)) k :
  reflect (in_universe u (world_of_numbers V C k)) (in_universe_in u M k).
Proof. by case: u => /=; [exact: ReflectT | exact: simple_in_numbers]. Qed.

Theorem directional_check_correct m : directional_check r limit u m <->
  forall W : lighthouse_world, in_universe u W -> edges W <= m -> right_in W.
Proof.
apply: (@check_correct _ _ r limit _ _ (@percept_of) (in_universe u)).
- exact: same_percept.
- exact: in_universe_same.
- exact: directional_senses_percept.
exact: in_universe_numbers.
Qed.

Theorem directional_refutation m M k : (M, k) \in directional_refutations r limit u m ->
  exists (V : valid M) (C : connected (denote M)), let W := world_of_numbers V C k in
  [/\ in_universe u W, edges W = m & ~ right_in W].
Proof.
apply: (@refutation_correct _ _ r limit _ _ (@percept_of) (in_universe u)).
  exact: directional_senses_percept.
exact: in_universe_numbers.
Qed.
End Directional.

(* ---- Algorithm 1 ---- *)
Definition paper_limit n m :=
  sumn [seq s + 2 * (s - 1) * (2 * m - 2 * (s - 1)) | s <- iota 1 n.-1] +
  sumn [seq n + 2 * (n - 1) * (2 * m - 2 * (n - 1) - 2 * (i - 1)) | i <- iota 1 (m - (n - 1))].

Theorem paper_limitE n m : paper_limit n m = paper_bound n m.
Proof.
by rewrite /paper_limit /paper_bound /sum_1 /sum_2 !sumnE !big_map /index_iota subn1 subSS subn0.
Qed.

Definition algorithm1_resumption pol : resumption (program percept knowledge) percept :=
  Resumption (set_out directional) (act directional pol) (sense directional pol).

Theorem algorithm1_is_resumption pol : as_explorer (algorithm1_resumption pol) = algorithm1 pol.
Proof. by []. Qed.

Theorem algorithm1_checked pol u m :
  directional_check (algorithm1_resumption pol) (fun n m _ => paper_limit n m) u m.
Proof.
apply/directional_check_correct=> W _ _; rewrite algorithm1_is_resumption paper_limitE.
by apply/right_withinE; have [t [e [z [R _ V I]]]] := algorithm1_correct (W := W) pol (leqnn _); exists t, e, z.
Qed.

(* the theorem in numbers, with the bound that is meant *)
Theorem algorithm1_within M k pol budget : valid M -> size (dart_order M) == size (sigma_list M) ->
  let limit := paper_limit (vertices_in M) (edges_in M) in limit <= budget ->
  exists transcript answer z,
  [/\ episode (algorithm1 pol) (denote M) (directional_senses M k) budget
        = (transcript, Some answer, z),
      size transcript <= limit & same_code answer (seen_from M z)].
Proof.
move=> V /(connectedP V) C; rewrite /= paper_limitE -(vertices_in_numbers V C) -(edges_in_numbers V C).
exact: (@algorithm1_in_numbers M V C k pol budget).
Qed.
