(* ---------------------------------------------------------------------------------------------
   Decision trees: what an explorer does in all worlds with at most m edges, written down.  A file that
   holds one, with m, is a certificate that the explorer is right in these worlds: Coq's kernel checks it
   by computation, and nothing else is computed.  `python proofs/certified.py --certificate` writes one.

     decision_tree        Leaf e: stop, with the answer e.  Node k after: make motion k; `after` has a
                          branch for each percept that may be sensed then, with what to do next.
     branches             percepts, each with a decision tree.  A certificate holds the branches of the
                          first percept.
     branch_to b o        the first branch of b for percept o, if there is one.
     said b seen          what the branches b say is done after the percepts seen; None: nothing.
     answers_as X b       wherever b says what is done, explorer X does it.  What X does elsewhere is
                          left open.
     tree_resumption b    the explorer that does as b says, and where b says nothing stops with an answer
                          that is no map.
     certified b limit u m   this explorer passes the checker (Checker.v), which enumerates the worlds by
                          itself (Enumeration.v), so that no branch of a world can be missing.

     certified_right      certified b limit u m if and only if every explorer that answers as b is right
                          within the limit in every world of u with at most m edges.
     tree_answered        there is such an explorer.
     certified_paper, certified_paper_simple   what a certificate states, with (1)+(2) as the limit.
     certified_limit, certified_limit_simple   what it states with any other.
     limit_from           a limit that is given as a list of numbers.
     one_edge_tree             the tree of Algorithm 1 for the two worlds with one edge.
   --------------------------------------------------------------------------------------------- *)
From mathcomp Require Import all_ssreflect.
From Allworlds Require Import Model Codes Explorers Checker.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Inductive decision_tree :=
| Leaf (e : numbered_map)
| Node (k : nat) (after : seq (percept * decision_tree)).
Definition branches := seq (percept * decision_tree).

Fixpoint branch_to (b : branches) (o : percept) : option decision_tree :=
  if b is (p, t) :: b' then if p == o then Some t else branch_to b' o else None.

Fixpoint said (b : branches) (seen : seq percept) : option (action numbered_map) :=
  if seen is o :: seen' then
    match branch_to b o with
    | Some (Leaf e) => if seen' is [::] then Some (Stop e) else None
    | Some (Node k after) => if seen' is [::] then Some (Move k) else said after seen'
    | None => None
    end
  else None.

Definition answers_as (X : explorer percept numbered_map) (b : branches) :=
  forall seen a, said b seen = Some a -> X seen = a.

(* ---- The explorer that does as the tree says ---- *)
Definition no_map := NumberedMap [::] [::] 0.
Definition tree_decides (s : option decision_tree) : action numbered_map :=
  match s with
  | Some (Leaf e) => Stop e
  | Some (Node k _) => Move k
  | None => Stop no_map
  end.
Definition tree_goes_on (s : option decision_tree) o :=
  if s is Some (Node _ after) then branch_to after o else None.
Definition tree_resumption (b : branches) : resumption (option decision_tree) percept :=
  Resumption (branch_to b) tree_decides tree_goes_on.

Definition certified (b : branches) limit u m := directional_check (tree_resumption b) limit u m.

(* where it stands in the tree after some percepts, and what is said there *)
Definition stands b o seen := foldl tree_goes_on (branch_to b o) seen.

Lemma stands_nowhere seen : foldl tree_goes_on None seen = None.
Proof. by elim: seen. Qed.

Lemma saidE b o seen :
  said b (o :: seen) = if stands b o seen is Some t then Some (tree_decides (Some t)) else None.
Proof.
rewrite /stands; elim: seen b o => [|o' seen IH] b o /=; first by case: (branch_to b o) => // -[].
by case: (branch_to b o) => [[e|k after]|]; rewrite ?stands_nowhere -?IH.
Qed.

Lemma tree_answers b : answers_as (as_explorer (tree_resumption b)) b.
Proof.
move=> [|o seen] a //; rewrite saidE [as_explorer _ _]/= -/(stands b o seen).
by case: (stands b o seen) => // t [].
Qed.

Theorem tree_answered b : exists X, answers_as X b.
Proof. exists (as_explorer (tree_resumption b)); exact: tree_answers. Qed.

(* an explorer that answers as the tree does what the tree's does, where this one ends with a map *)
Lemma answers_explore X b : answers_as X b ->
  forall (M : rooted_map) (senses : carrier M -> percept) fuel o seen d t e z, valid e ->
  explore (as_explorer (tree_resumption b)) M senses fuel (o :: seen) d = (t, Some e, z) ->
  explore X M senses fuel (o :: seen) d = (t, Some e, z).
Proof.
move=> F M senses; elim=> [|fuel IH] o seen d t e z Ve /=; rewrite -/(stands b o seen);
  have := F (o :: seen); rewrite saidE; case: (stands b o seen) => [s|] H.
- by rewrite (H _ erefl).
- by case=> _ E _; rewrite -E in Ve.
- rewrite (H _ erefl); case: (tree_decides _) => // k.
  case E: (explore _ _ _ _ _ _) => [[t' a] z'] [<- A <-]; subst a.
  by rewrite (IH _ _ _ _ _ _ Ve E).
by case=> _ E _; rewrite -E in Ve.
Qed.

Lemma answers_right X b (M : rooted_map) (senses : carrier M -> percept) limit : answers_as X b ->
  right_within (as_explorer (tree_resumption b)) senses limit -> right_within X senses limit.
Proof.
move=> F /right_withinE [t [e [z [R V I]]]]; apply/right_withinE; exists t, e, z; split=> //.
exact: answers_explore R.
Qed.

Theorem certified_right b limit u m : certified b limit u m <->
  forall X, answers_as X b -> forall W : lighthouse_world, in_universe u W -> edges W <= m ->
  right_within X (M := rooted (@start W)) (@percept_of W)
    (limit (vertices W) (edges W) (degree (@start W))).
Proof.
split=> [/directional_check_correct H X F W uW le|H]; first exact: answers_right F (H W uW le).
by apply/directional_check_correct=> W uW le; apply: H uW le; exact: tree_answers.
Qed.

(* ---- What a certificate states ---- *)
Lemma certified_limit b limit m : certified b limit AllWorlds m ->
  forall X, answers_as X b -> forall W : lighthouse_world, edges W <= m ->
  exists transcript answer z,
  [/\ episode X (rooted start) (@percept_of W) (limit (vertices W) (edges W) (degree (@start W)))
        = (transcript, Some answer, z),
      valid answer & isomorphic (denote answer) (rooted z)].
Proof. by move=> /certified_right H X F W le; have /right_withinE := H X F W I le. Qed.

Lemma certified_limit_simple b limit m : certified b limit SimpleWorlds m ->
  forall X, answers_as X b -> forall W : lighthouse_world, simple_world W -> edges W <= m ->
  exists transcript answer z,
  [/\ episode X (rooted start) (@percept_of W) (limit (vertices W) (edges W) (degree (@start W)))
        = (transcript, Some answer, z),
      valid answer & isomorphic (denote answer) (rooted z)].
Proof. by move=> /certified_right H X F W sW le; have /right_withinE := H X F W sW le. Qed.

Definition paper n m (_ : nat) := paper_limit n m.

Theorem certified_paper b m : certified b paper AllWorlds m ->
  forall X, answers_as X b -> forall W : lighthouse_world, edges W <= m ->
  exists transcript answer z,
  [/\ episode X (rooted start) (@percept_of W) (paper_bound (vertices W) (edges W))
        = (transcript, Some answer, z),
      valid answer & isomorphic (denote answer) (rooted z)].
Proof. by move=> H X F W le; have := certified_limit H F le; rewrite /paper paper_limitE. Qed.

Theorem certified_paper_simple b m : certified b paper SimpleWorlds m ->
  forall X, answers_as X b -> forall W : lighthouse_world, simple_world W -> edges W <= m ->
  exists transcript answer z,
  [/\ episode X (rooted start) (@percept_of W) (paper_bound (vertices W) (edges W))
        = (transcript, Some answer, z),
      valid answer & isomorphic (denote answer) (rooted z)].
Proof. by move=> H X F W sW le; have := certified_limit_simple H F sW le; rewrite /paper paper_limitE. Qed.

(* rows: n, m and deg(v0), each with the limit in such worlds; in others it is 0 *)
Fixpoint limit_from (rows : seq (nat * nat * nat * nat)) n m d0 :=
  if rows is (n', m', d', limit) :: rows' then
    if [&& n' == n, m' == m & d' == d0] then limit else limit_from rows' n m d0
  else 0.

(* ---- The smallest certificate, and what is none ---- *)
Definition one_edge_tree : branches :=
  [:: ((1, Some 0), Node 0 [:: ((1, None), Leaf (NumberedMap [:: 0; 1] [:: 1; 0] 1))]);
      ((2, Some 0), Node 0 [:: ((2, Some 1), Leaf (NumberedMap [:: 1; 0] [:: 1; 0] 1))]);
      ((2, Some 1), Node 0 [:: ((2, Some 0), Leaf (NumberedMap [:: 1; 0] [:: 1; 0] 1))])].

Example one_edge_certified : certified one_edge_tree paper AllWorlds 1 = true.
Proof. by vm_compute. Qed.
Example one_edge_says : [seq said one_edge_tree seen | seen <-
    [:: [::]; [:: (1, Some 0)]; [:: (1, Some 0); (1, None)]; [:: (2, Some 1); (2, Some 0)]; [:: (1, None)];
        [:: (2, Some 1); (2, Some 1)]; [:: (1, Some 0); (1, None); (1, None)]]]
  = [:: None; Some (Move 0); Some (Stop (NumberedMap [:: 0; 1] [:: 1; 0] 1));
        Some (Stop (NumberedMap [:: 1; 0] [:: 1; 0] 1)); None; None; None].
Proof. by []. Qed.

(* not with two edges, not where a branch is missing, not where the limit is smaller than the walks *)
Example one_edge_not_two : certified one_edge_tree paper AllWorlds 2 = false.
Proof. by vm_compute. Qed.
Example branch_missing : certified (behead one_edge_tree) paper AllWorlds 1 = false.
Proof. by vm_compute. Qed.
Example limit_too_small : certified one_edge_tree (fun _ _ _ => 0) AllWorlds 1 = false.
Proof. by vm_compute. Qed.
Example limit_from_rows :
  [seq limit_from [:: (1, 1, 2, 5); (2, 1, 1, 7)] w.1.1 w.1.2 w.2 | w <-
    [:: (1, 1, 2); (2, 1, 1); (1, 1, 1); (2, 1, 2); (2, 2, 1)]] = [:: 5; 7; 0; 0; 0].
Proof. by []. Qed.
