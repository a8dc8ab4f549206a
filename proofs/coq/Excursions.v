(* ---------------------------------------------------------------------------------------------
   Worlds with v0 at the end of a path, and what it costs to come back.                Section VI

     path_from_start      v0 lies at the end of a path of L edges; level: how far on the path, L from its
                          other end on; up: the darts of the path that lead away from v0.
     returns              the entries into v0 after the far end of the path has been reached.
     returns_cost_start   each of them costs the path twice.
     sheets_entered c     in which copy (TwoSheets.v) each of them enters v0.
     sheets_quiet         always in the first: then the walk is quiet.
   --------------------------------------------------------------------------------------------- *)
From mathcomp Require Import all_ssreflect.
From Allworlds Require Import Model Maps Percepts TwoSheets.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

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

