(* ---------------------------------------------------------------------------------------------
   Laying the marker cluster: three markers, dropped by the robot itself.         Sections IV and VIII

   A world with markers as state.  At first none lies anywhere; the robot senses the degree and how many
   markers lie at its vertex, and may drop one there.  Markers are not picked up again.

     deed, marking_explorer   what such a robot does next: a motion, a drop, or the answer; and the
                          explorer, any function from the percepts so far (one after each deed) to a deed.
     drop d m             the markers m with one more at the vertex of d.
     marking_episode      the explorer in a world without markers: the transcript (deeds other than the
                          answer, each with what was sensed after it), the answer, the robot's true dart.
     traversals t         the motions of a transcript.

     laying               a program that may drop markers.
     lay_round, lay       drop one marker at v0; leave by one dart after the other; where a marker is seen
                          it was a loop; where none is, drop two, and come back: the place of that dart.
     loops_before W       the pointed dart is the first from the start that is no loop.
     round_makes          there the program finds it, and then the markers lie as in Cluster.v.
     laying_algorithm     lay, then Algorithm 1 with the cluster.
     laying_correct       it is right, in (1)+(2), two traversals for each test, and 2 deg(v0) for laying,
                          where one edge only joins v0 and v1.
   --------------------------------------------------------------------------------------------- *)
From mathcomp Require Import all_ssreflect.
From Allworlds Require Import Model Maps Percepts RootedMaps Explorers PartialMaps Lighthouses Algorithm.
From Allworlds Require Import Execution TwoVertices Cluster.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Definition sight := (nat * nat)%type.

(* ---- Explorers that drop markers ---- *)
Inductive deed E := Step (k : nat) | Drop | Answer (a : E).
Arguments Step {E} k.
Arguments Drop {E}.
Arguments Answer {E} a.
Definition marking_explorer E := seq sight -> deed E.

Section World.
Variable G : combinatorial_map.
Implicit Types (d : G) (m : G -> nat).

Definition drop d m : G -> nat := fun x => m x + at_same_vertex d x.
Definition sees m d : sight := (degree d, m d).

(* Some k: motion k; None: a drop *)
Fixpoint explore_marking E (X : marking_explorer E) budget seen d m :
    seq (option nat * sight) * option E * G :=
  match X seen with
  | Answer a => ([::], Some a, d)
  | Step k =>
      if budget is budget'.+1 then
        let d' := motion k d in
        let: (t, a, z) := explore_marking X budget' (rcons seen (sees m d')) d' m in
        ((Some k, sees m d') :: t, a, z)
      else ([::], None, d)
  | Drop =>
      if budget is budget'.+1 then
        let m' := drop d m in
        let: (t, a, z) := explore_marking X budget' (rcons seen (sees m' d)) d m' in
        ((None, sees m' d) :: t, a, z)
      else ([::], None, d)
  end.
Definition marking_episode E (X : marking_explorer E) d budget :=
  explore_marking X budget [:: sees (fun=> 0) d] d (fun=> 0).
End World.

Definition traversals (t : seq (option nat * sight)) := count (fun s => isSome s.1) t.

(* ---- Programs that drop markers ---- *)
Inductive laying A := Laid (x : A) | StepThen (k : nat) (f : sight -> laying A)
  | DropThen (f : sight -> laying A).
Arguments Laid {A} x.

(* what the program does next; or its result and what was sensed since *)
Fixpoint progress A (p : laying A) (seen : seq sight) : laying A * seq sight :=
  match p, seen with
  | StepThen _ f, o :: seen' | DropThen f, o :: seen' => progress (f o) seen'
  | _, _ => (p, seen)
  end.

Section Then.
Variables (E A : Type) (start : sight -> laying A) (go_on : A -> seq sight -> action E).

Definition lay_then : marking_explorer E := fun seen =>
  let: (p, rest) := progress (start (head (0, 0) seen)) (behead seen) in
  match p with
  | StepThen k _ => Step k
  | DropThen _ => Drop
  | Laid x => match go_on x rest with Move k => Step k | Stop a => Answer a end
  end.
End Then.

Fixpoint lay_round (n j left c : nat) : laying (nat * nat) :=
  if left is left'.+1 then
    StepThen c (fun o =>
      if o.2 is 0 then DropThen (fun _ => DropThen (fun _ => StepThen 0 (fun _ => Laid (n, j))))
      else StepThen 0 (fun _ => lay_round n j.+1 left' 1))
  else Laid (n, 0).
Definition lay (o : sight) := DropThen (fun _ => lay_round o.1 0 o.1 0).

Definition laying_algorithm pol : marking_explorer numbered_map :=
  lay_then lay (fun nj seen => act cluster pol
    (foldl (sense cluster pol) (Return (knowledge_at_v0 nj.1 nj.2 (opposite nj.1 nj.2))) seen)).

(* ---- In a world ---- *)
Section InWorld.
Variables (E A : Type) (start : sight -> laying A) (go_on : A -> seq sight -> action E).
Variable G : combinatorial_map.
Local Notation X := (lay_then start go_on).

(* program p, run from dart d with the markers m *)
Inductive lays : laying A -> G -> (G -> nat) -> seq (option nat * sight) ->
    A -> G -> (G -> nat) -> Prop :=
| LaysLaid x d m : lays (Laid x) d m [::] x d m
| LaysStep k f d m t x z m' : lays (f (sees m (motion k d))) (motion k d) m t x z m' ->
    lays (StepThen k f) d m ((Some k, sees m (motion k d)) :: t) x z m'
| LaysDrop f d m t x z m' : lays (f (sees (drop d m) d)) d (drop d m) t x z m' ->
    lays (DropThen f) d m ((None, sees (drop d m) d) :: t) x z m'.

Lemma progress_nil (p : laying A) : progress p [::] = (p, [::]).
Proof. by case: p. Qed.

Lemma progress_rcons (p : laying A) seen o :
  progress p (rcons seen o) = let: (q, rest) := progress p seen in progress q (rcons rest o).
Proof.
elim: seen p => [|o' seen IH] p /=; first by case: p.
by case: p => [x|k f|f] //=; rewrite IH.
Qed.

Lemma lays_explores p d m t x z m' : lays p d m t x z m' ->
  forall o seen budget, progress (start o) seen = (p, [::]) ->
  explore_marking X (size t + budget) (o :: seen) d m
  = (let: (t', a, z') := explore_marking X budget (o :: seen ++ unzip2 t) z m' in (t ++ t', a, z')) /\
  progress (start o) (seen ++ unzip2 t) = (Laid x, [::]).
Proof.
elim=> [{}x {}d {}m|k f {}d {}m {}t {}x {}z {}m' _ IH|f {}d {}m {}t {}x {}z {}m' _ IH] o seen budget P.
- by rewrite cats0 add0n; case: (explore_marking _ _ _ _ _) => [[? ?] ?].
- set o' := sees m (motion k d) in IH *.
  have P' : progress (start o) (rcons seen o') = (f o', [::]) by rewrite progress_rcons P /= progress_nil.
  have [R Q] := IH o (rcons seen o') budget P'; rewrite cat_rcons in R Q; split=> //.
  rewrite /= {1}/lay_then /= P /= -/o' R.
  by case: (explore_marking _ _ _ _ _) => [[? ?] ?].
set o' := sees (drop d m) d in IH *.
have P' : progress (start o) (rcons seen o') = (f o', [::]) by rewrite progress_rcons P /= progress_nil.
have [R Q] := IH o (rcons seen o') budget P'; rewrite cat_rcons in R Q; split=> //.
rewrite /= {1}/lay_then /= P /= -/o' R.
by case: (explore_marking _ _ _ _ _) => [[? ?] ?].
Qed.
End InWorld.

(* ---- Then Algorithm 1 ---- *)
Section Algorithm.
Variables (W : lighthouse_world) (pol : policy).
Local Notation v0 := (@start W).
Local Notation X := (laying_algorithm pol).
Local Notation machine := (machine cluster pol motion).
Local Notation first_known nj := (knowledge_at_v0 nj.1 nj.2 (opposite nj.1 nj.2)).

Lemma resumes m nj o seen rest p budget (d : W) : progress (lay o) seen = (Laid nj, rest) ->
  p = foldl (sense cluster pol) (Return (first_known nj)) rest ->
  explore_marking X budget (o :: seen) d m
  = let: (t, a, z) := machine (sees m) budget p d in ([seq (Some s.1, s.2) | s <- t], a, z).
Proof.
have deedE s r : progress (lay o) s = (Laid nj, r) -> X (o :: s) =
    match act cluster pol (foldl (sense cluster pol) (Return (first_known nj)) r) with
    | Move k => Step k | Stop a => Answer a end.
  by rewrite /laying_algorithm /lay_then [head _ _]/= [behead _]/= => ->.
elim: budget seen rest p d => [|n IH] seen rest p d P pE; rewrite [LHS]/= (deedE _ _ P) -pE /act /=.
  by case: (next _ _ p) => [e|[k f]].
case N: (next _ _ p) => [e|[k f]] //=; set o' := sees m _.
have P' : progress (lay o) (rcons seen o') = (Laid nj, rcons rest o').
  by rewrite progress_rcons P; case: (rest).
rewrite (IH _ _ (f o') _ P'); last by rewrite -cats1 foldl_cat /= -pE /sense N.
by case: (machine _ _ _ _) => [[? ?] ?].
Qed.

Definition loops_before := forall i, i < first_bearing W -> at_same_vertex v0 (alpha (iter i sigma v0)).
Hypothesis loops : loops_before.
Hypothesis one : one_edge W.

Lemma round_makes left j c (d : W) m : m =1 drop v0 (fun=> 0) -> iter c sigma d = iter j sigma v0 ->
  j <= first_bearing W -> first_bearing W < j + left -> exists t m',
  [/\ lays (lay_round (degree v0) j left c) d m t (degree v0, first_bearing W) pointed m',
      m' =1 @marks W, traversals t = 2 * (first_bearing W - j).+1 & size t = (traversals t).+2].
Proof.
elim: left j c d m => [|left IH] j c d m mE dE jb bj; first by rewrite addn0 ltnNge jb in bj.
have dE' : motion c d = alpha (iter j sigma v0) by rewrite /motion dE.
have back x : motion 0 (alpha x) = x :> W by rewrite /motion /= alphaK.
have marked x : m x = at_same_vertex v0 x by rewrite mE /drop add0n.
case: (ltngtP j (first_bearing W)) jb => // [jb _|jE _]; last first.
  have pE : iter j sigma v0 = pointed by rewrite jE; exact: iter_findex (@pointed_at_v0 W).
  rewrite pE in dE'; have ap := one_edge_apart one; set m' := drop (motion c d) m.
  exists [:: (Some c, sees m (motion c d)); (None, sees m' (motion c d));
             (None, sees (drop (motion c d) m') (motion c d));
             (Some 0, sees (drop (motion c d) m') (motion 0 (motion c d)))], (drop (motion c d) m').
  split=> [|x||//]; last by rewrite jE subnn.
    have E : pointed = motion 0 (motion c d) by rewrite dE' back.
    have unseen : m (motion c d) = 0 by rewrite marked dE' (negbTE ap).
    rewrite E; apply: LaysStep; rewrite /= unseen; do 2 apply: LaysDrop.
    by apply: LaysStep; rewrite -jE; exact: LaysLaid.
  rewrite /m' /drop marked dE' /marks -addnA addnn; case: ifP => [c0|_]; last by case: ifP.
  case: (boolP (at_same_vertex _ x)) => // c1; case/negP: ap; apply: connect_trans c0 _.
  by rewrite -/(at_same_vertex _ _) at_same_vertex_sym.
have [|||t [m' [L mE' tr sz]]] := IH j.+1 1 (iter j sigma v0) m mE => //; first by rewrite addSn -addnS.
have E : motion 0 (motion c d) = iter j sigma v0 by rewrite dE' back.
exists [:: (Some c, sees m (motion c d)), (Some 0, sees m (motion 0 (motion c d))) & t], m'; split=> //.
- have seen : m (motion c d) = 1 by rewrite marked dE' (loops jb).
  by apply: LaysStep; rewrite /= seen; apply: LaysStep; rewrite E.
- by rewrite /traversals /= -/(traversals t) tr -(subnSK jb) [RHS]mulnS.
by rewrite /traversals /= -/(traversals t) sz.
Qed.

Theorem laying_correct budget : 2 * degree v0 + cluster_bound W + 3 <= budget ->
  exists t answer z,
  [/\ marking_episode X v0 budget = (t, Some answer, z),
      traversals t <= 2 * degree v0 + cluster_bound W, size t = traversals t + 3,
      valid answer & isomorphic (denote answer) (rooted z)].
Proof.
move=> le; set b := first_bearing W; have lb : b < degree v0 by exact: findex_max (@pointed_at_v0 W).
have [//|//|//|//|t0 [m0 [L0 mE tr0 s0]]] := @round_makes (degree v0) 0 0 v0 (drop v0 (fun=> 0)).
rewrite subn0 in tr0; have [t1 [answer [z [R1 s1 V I]]]] := cluster_resumed one pol.
have L : lays (lay (sees (fun=> 0) v0)) v0 (fun=> 0)
  ((None, sees (drop v0 (fun=> 0)) v0) :: t0) (degree v0, b) pointed m0 by exact: LaysDrop.
set t := _ :: t0 in L; have sz : size t = (2 * b.+1) + 3 by rewrite /= s0 tr0 !addnS addn0.
have bound : traversals (t ++ [seq (Some s.1, s.2) | s <- t1]) = 2 * b.+1 + size t1.
  rewrite /traversals count_cat /= -/(traversals t0) tr0 add0n; congr (_ + _).
  by elim: (t1) => //= s t' ->.
have enough : size t + size t1 <= budget.
  apply: leq_trans le; rewrite sz addnAC -addnA [size t1 + 3]addnC addnA addnAC leq_add2r.
  by apply: leq_add => //; rewrite leq_mul2l.
exists (t ++ [seq (Some s.1, s.2) | s <- t1]), answer, z; split=> //.
- have [E P] := lays_explores (fun nj seen => act cluster pol
    (foldl (sense cluster pol) (Return (first_known nj)) seen)) L (budget - size t)
    (progress_nil (lay (sees (fun=> 0) v0))).
  have R2 : machine (sees m0) (budget - size t) (Return (first_known (degree v0, b))) pointed
      = (t1, Some answer, z).
    rewrite (machine_ext _ _ _ (s2 := @cluster_percept W)) => [|x]; last by rewrite /sees mE.
    rewrite -(subnKC (_ : size t1 <= budget - size t)) ?(machine_more _ R1) //.
    by rewrite leq_subRL ?(leq_trans (leq_addr _ _) enough).
  have Q := resumes m0 (budget - size t) pointed P (erefl _); rewrite R2 in Q.
  rewrite -(subnKC (leq_trans (leq_addr _ _) enough)); rewrite -/X in E.
  by rewrite /marking_episode E Q.
- by rewrite bound; apply: leq_add => //; rewrite leq_mul2l.
by rewrite bound size_cat size_map sz addnAC.
Qed.
End Algorithm.

(* in a simple world the first dart will do *)
Lemma simple_loops_before (G : combinatorial_map) (d : G) : simple_world G ->
  let W := @LighthouseWorld G d d (connect0 _ d) in loops_before W /\ one_edge W.
Proof.
move=> S W; split; last exact: simple_one_edge.
by move=> i; rewrite /first_bearing /= findex0.
Qed.
