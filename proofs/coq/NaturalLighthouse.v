(* ---------------------------------------------------------------------------------------------
   The natural lighthouse: a vertex v0 of unique degree next to a vertex v1 of unique degree.
                                                                                        Section VIII

   No marker at all: the robot senses degrees only.  It starts at v0, and is told the degree of v1; that
   a degree is unique cannot be seen.  Where exactly one edge joins v0 and v1, as in every simple world,
   this is an instance of TwoVertices.v.  Where two edges do it is not enough: Twins.v.

     natural a b, natural_algorithm b pol   the lighthouse, a and b being the two degrees, and the
                          explorer, which takes a from the first percept.
     unique d             no other vertex has the degree of the vertex of d.

     natural_correct      the explorer, under every policy, with any budget of at least (1)+(2), two
                          traversals a test and 2 deg(v0) for the search: it stops within that, and
                          is right.
     natural_hypotheses_met   worlds in which the hypotheses hold.
   --------------------------------------------------------------------------------------------- *)
From mathcomp Require Import all_ssreflect.
From Allworlds Require Import Model Maps Percepts RootedMaps Explorers Algorithm PathWorlds.
From Allworlds Require Import TwoVertices Cluster.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Definition has_degree (a o : nat) := o == a.
Definition natural (a b : nat) : lighthouse nat [eqType of bool] :=
  two_vertices id (has_degree a) (has_degree b).
Definition natural_algorithm b pol : explorer nat numbered_map :=
  fun seen => explorer_by (natural (head 0 seen) b) pol seen.

Section Natural.
Variable W : lighthouse_world.
Local Notation v0 := (@start W).
Local Notation v1 := (alpha (@pointed W)).

Definition unique (x : W) := forall d : W, degree d = degree x -> at_same_vertex x d.

Hypotheses (unique_v0 : unique v0) (unique_v1 : unique v1) (one : one_edge W).

Lemma degree_of x : unique x -> forall d : W, (degree d == degree x) = at_same_vertex x d.
Proof. by move=> u d; apply/eqP/idP=> [/u //|/degree_same]. Qed.

Theorem natural_correct pol budget : 2 * degree v0 + cluster_bound W <= budget ->
  exists transcript answer z,
  [/\ episode (natural_algorithm (degree v1) pol) (rooted v0) (@degree W) budget
        = (transcript, Some answer, z),
      size transcript <= 2 * degree v0 + cluster_bound W,
      valid answer & isomorphic (denote answer) (rooted z)].
Proof.
rewrite (chosen_episode (fun a => explorer_by (natural a _) pol)) /=; move: pol budget.
exact: (@two_vertices_correct W _ (@degree W) id (has_degree (degree v0)) (has_degree (degree v1))
  (fun=> erefl) (degree_of unique_v0) (degree_of unique_v1) one).
Qed.
End Natural.

(* ---- The hypotheses can be met: loops at one vertex, with an edge before it ---- *)
Section Met.
Variable k : nat.
Local Notation W := (longer (bouquet k)).

Lemma at_v0_or_v1 (d : W) : d = start \/ at_same_vertex (alpha pointed) d.
Proof.
case: d => [i|[]]; [right|by right; exact: connect0|by left].
rewrite at_same_vertex_sym; apply: connect_trans (longer_joined (bouquet k)).
by apply: longer_same; exact: bouquet_all.
Qed.

Lemma degree_v1 : degree (alpha (@pointed W)) <> degree (@start W).
Proof.
have <- : 1 = degree (@start W).
  apply/esym/eqP; rewrite /degree /order -(card1 (@start W)); apply/eqP/eq_card=> d.
  by rewrite !inE; apply/idP/eqP=> [/longer_start|->]; [|exact: connect0].
by move=> E; have := iter_degree (alpha (@pointed W)); rewrite E.
Qed.

Theorem natural_hypotheses_met :
  [/\ unique (@start W), unique (alpha (@pointed W)) & one_edge W].
Proof.
split=> [d E|d E|]; last exact: cluster_hypotheses_met.
  case: (at_v0_or_v1 d) => [->|/degree_same E1]; first exact: connect0.
  by case: degree_v1; rewrite -E1.
by case: (at_v0_or_v1 d) E => [-> E|//]; case: degree_v1.
Qed.
End Met.
