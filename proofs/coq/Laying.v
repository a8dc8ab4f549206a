(* ---------------------------------------------------------------------------------------------
   Laying the marker cluster: three markers, dropped by the robot itself.         Sections IV and VIII

   At first the markers are in the robot's hand (Carrying.v).  It drops them, and does not pick them up.

     traversals t         the motions of a transcript.
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
From Allworlds Require Import Execution TwoVertices Cluster Carrying.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Definition traversals (t : seq (operation * view)) :=
  count (fun s => if s.1 is Leave _ then true else false) t.

Fixpoint lay_round (n j left c : nat) : plan (nat * nat) :=
  if left is left'.+1 then
    Do (Leave c) (fun o =>
      if o.2 is 0 then
        Do PutDown (fun _ => Do PutDown (fun _ => Do (Leave 0) (fun _ => Done (n, j))))
      else Do (Leave 0) (fun _ => lay_round n j.+1 left' 1))
  else Done (n, 0).
Definition lay (o : view) := Do PutDown (fun _ => lay_round o.1 0 o.1 0).

Definition first_known nj := knowledge_at_v0 nj.1 nj.2 (opposite nj.1 nj.2).
Definition laying_algorithm pol : carrying_explorer numbered_map :=
  repeated (fun o => after (lay o) (fun nj => Done (first_known nj)))
    (fun k => as_plan (one_pass cluster pol k)).

Section Algorithm.
Variables (W : lighthouse_world) (pol : policy).
Local Notation v0 := (@start W).
Local Notation v1 := (alpha (@pointed W)).
Local Notation laid := [:: v1; v1; v0].

Definition loops_before := forall i, i < first_bearing W -> at_same_vertex v0 (alpha (iter i sigma v0)).
Hypothesis loops : loops_before.
Hypothesis one : one_edge W.

Lemma view_laid d : view_of (d, laid) = cluster_percept d.
Proof.
rewrite /view_of /cluster_percept /marks /= /lies_here /=; congr (_, _).
case: (boolP (at_same_vertex v1 d)) => c1; case: (boolP (at_same_vertex v0 d)) => c0 //.
case/negP: (one_edge_apart one); apply: connect_trans c0 _.
by rewrite -/(at_same_vertex _ _) at_same_vertex_sym.
Qed.

Lemma round_makes left j c (d : W) : iter c sigma d = iter j sigma v0 ->
  j <= first_bearing W -> first_bearing W < j + left -> exists t,
  [/\ gives 3 (lay_round (degree v0) j left c) (d, [:: v0]) (degree v0, first_bearing W) (pointed, laid) t,
      traversals t = 2 * (first_bearing W - j).+1 & size t = (traversals t).+2].
Proof.
elim: left j c d => [|left IH] j c d dE jb bj; first by rewrite addn0 ltnNge jb in bj.
have dE' : motion c d = alpha (iter j sigma v0) by rewrite /motion dE.
have back x : motion 0 (alpha x) = x :> W by rewrite /motion /= alphaK.
have marked s : (view_of (s, [:: v0])).2 = at_same_vertex v0 s by rewrite /= addn0.
case: (ltngtP j (first_bearing W)) jb => // [jb _|jE _]; last first.
  have pE : iter j sigma v0 = pointed by rewrite jE; exact: iter_findex (@pointed_at_v0 W).
  rewrite pE in dE'; have ap := one_edge_apart one.
  eexists; split; first apply: GivesDo; first by [].
  - rewrite marked dE' (negbTE ap); do 2 (apply: GivesDo; first by []).
    by apply: GivesDo; [rewrite /= back | rewrite -jE; exact: GivesDone].
  - by rewrite jE subnn.
  by [].
have [|||t [L tr sz]] := IH j.+1 1 (iter j sigma v0) => //; first by rewrite addSn -addnS.
eexists; split; first apply: GivesDo; first by [].
- rewrite marked dE' (loops jb); apply: GivesDo; first by rewrite /= back.
  exact: L.
- by rewrite /traversals /= -/(traversals t) tr -(subnSK jb) [RHS]mulnS.
by rewrite /traversals /= -/(traversals t) sz.
Qed.

Theorem laying_correct budget : 2 * degree v0 + cluster_bound W + 3 <= budget ->
  exists t answer z,
  [/\ carrying_episode 3 (laying_algorithm pol) v0 budget = (t, Some answer, (z, laid)),
      traversals t <= 2 * degree v0 + cluster_bound W, size t = traversals t + 3,
      valid answer & isomorphic (denote answer) (rooted z)].
Proof.
move=> le; set b := first_bearing W; have lb : b < degree v0 by exact: findex_max (@pointed_at_v0 W).
have [//|//|//|t0 [L0 tr0 s0]] := @round_makes (degree v0) 0 0 v0.
rewrite subn0 in tr0; have [t1 [answer [z [R1 s1 V I]]]] := cluster_resumed one pol.
have L : gives 3 (lay (view_of (v0, [::]))) (v0, [::]) (degree v0, b) (pointed, laid)
    ((PutDown, view_of (v0, [:: v0])) :: t0) by exact: GivesDo.
set t := _ :: t0 in L; have sz : size t = (2 * b.+1) + 3 by rewrite /= s0 tr0 !addnS addn0.
have bound : traversals (t ++ [seq (Leave s.1, s.2) | s <- t1]) = 2 * b.+1 + size t1.
  rewrite /traversals count_cat /= -/(traversals t0) tr0 add0n; congr (_ + _).
  by elim: (t1) => //= s t' ->.
have enough : size t + size t1 <= budget.
  apply: leq_trans le; rewrite sz addnAC -addnA [size t1 + 3]addnC addnA addnAC leq_add2r.
  by apply: leq_add => //; rewrite leq_mul2l.
exists (t ++ [seq (Leave s.1, s.2) | s <- t1]), answer, z; split=> //.
- have M := gives_after (f := fun nj => Done (first_known nj)) L (GivesDone _ _ _).
  rewrite episode_perform -(subnKC enough) -addnA.
  rewrite cats0 in M; rewrite (perform_gives _ _ M) -[Done _]/(as_plan (Return _)) perform_as_plan.
  by rewrite (machine_ext _ _ _ view_laid) (machine_more _ R1).
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
