(* ---------------------------------------------------------------------------------------------
   Decision trees: what an explorer does in all worlds with at most m edges, written down.  A file that
   holds one, with m, is a certificate that the explorer is right in these worlds: Coq's kernel checks it
   by computation, and nothing else is computed.  `python proofs/coq/certified.py --certificate` writes one.

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

     unrolled os fuel seen   what explorer X does after the percepts seen, to so many motions, if what is
                          sensed is one of the percepts os; unrolled_from os fuel: the same from the start.
     percepts_to m        all that is sensed in worlds with at most m edges.
     largest limit m      the largest limit in these worlds.
     certificate_exists   an explorer has a certificate if and only if it is right in these worlds.

     certified_paper, certified_paper_simple   what a certificate states, with (1)+(2) as the limit.
     certified_limit, certified_limit_simple   what it states with any other.
     limit_from           a limit that is given as a list of numbers.
     one_edge_tree             the tree of Algorithm 1 for the two worlds with one edge.
   --------------------------------------------------------------------------------------------- *)
From mathcomp Require Import all_ssreflect.
From Allworlds Require Import Model Maps Codes Explorers Checker.
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

(* ---- Every right explorer has a certificate ---- *)
Section Unrolled.
Variable X : explorer percept numbered_map.

Fixpoint unrolled (os : seq percept) fuel seen : decision_tree :=
  match X seen with
  | Stop e => Leaf e
  | Move k =>
      Node k (if fuel is fuel'.+1 then [seq (o, unrolled os fuel' (rcons seen o)) | o <- os] else [::])
  end.
Definition unrolled_from os fuel : branches := [seq (o, unrolled os fuel [:: o]) | o <- os].

Lemma branch_to_map (f : percept -> decision_tree) os o :
  branch_to [seq (p, f p) | p <- os] o = if o \in os then Some (f o) else None.
Proof. by elim: os => //= p os ->; rewrite inE eq_sym; case: eqP => // ->. Qed.

Lemma unrolled_decides os fuel seen : tree_decides (Some (unrolled os fuel seen)) = X seen.
Proof. by case: fuel => [|fuel] /=; case: (X seen). Qed.

Lemma unrolled_goes_on os fuel seen k o : X seen = Move k -> o \in os ->
  tree_goes_on (Some (unrolled os fuel.+1 seen)) o = Some (unrolled os fuel (rcons seen o)).
Proof. by move=> E os_o; rewrite /= E branch_to_map os_o. Qed.

Lemma unrolled_stands os fuel seen more t :
  foldl tree_goes_on (Some (unrolled os fuel seen)) more = Some t ->
  tree_decides (Some t) = X (seen ++ more).
Proof.
elim: more fuel seen => [|o more IH] fuel seen.
  by case=> <-; rewrite cats0 unrolled_decides.
rewrite -cat_rcons [foldl _ _ _]/=; case: fuel => [|fuel] /=; case: (X seen) => [k|e] /=;
  rewrite ?stands_nowhere // branch_to_map; case: ifP => _; rewrite ?stands_nowhere //; exact: IH.
Qed.

Lemma unrolled_answers os fuel : answers_as X (unrolled_from os fuel).
Proof.
move=> [|o seen] a //; rewrite saidE /stands branch_to_map; case: ifP => _; rewrite ?stands_nowhere //.
by case E: (foldl _ _ _) => [t|] //; have D := unrolled_stands E; case=> <-; rewrite -D.
Qed.

Lemma unrolled_explore os n (M : rooted_map) (senses : carrier M -> percept) :
  (forall d, senses d \in os) -> forall fuel m o seen d t e z, fuel <= m ->
  stands (unrolled_from os n) o seen = Some (unrolled os m (o :: seen)) ->
  explore X M senses fuel (o :: seen) d = (t, Some e, z) ->
  explore (as_explorer (tree_resumption (unrolled_from os n))) M senses fuel (o :: seen) d
    = (t, Some e, z).
Proof.
move=> listed; elim=> [|fuel IH] m o seen d t e z le S.
  by rewrite /= -/(stands _ o seen) S unrolled_decides; case: (X (o :: seen)).
rewrite /= -/(stands _ o seen) S unrolled_decides; case E: (X (o :: seen)) => [k|a]; last by [].
case R: (explore _ _ _ _ _ _) => [[t' a'] z'] [<- A <-]; subst a'.
case: m le S => // m le S; rewrite (IH m _ _ _ _ _ _ _ _ R) //.
rewrite /stands -[rcons seen _]cats1 foldl_cat -/(stands _ o seen) S cats1.
exact: unrolled_goes_on E (listed _).
Qed.
End Unrolled.

(* all that is sensed in worlds with at most m edges *)
Definition percepts_to m : seq percept :=
  flatten [seq (d, None) :: [seq (d, Some b) | b <- iota 0 d] | d <- iota 0 m.*2.+1].

Lemma percept_listed (W : lighthouse_world) m (d : W) : edges W <= m -> percept_of d \in percepts_to m.
Proof.
move=> le; apply/flattenP; exists ((degree d, None) :: [seq (degree d, Some b) | b <- iota 0 (degree d)]).
  apply: (map_f (fun d => (d, None) :: [seq (d, Some b) | b <- iota 0 d])).
  rewrite mem_iota ltnS; apply: leq_trans (max_card _) _; rewrite -(edges_double W) leq_double //.
rewrite /percept_of /bearing inE; case: ifP => c; last by rewrite eqxx.
by apply/orP; right; apply: map_f; rewrite mem_iota; exact: findex_max.
Qed.

Definition largest (limit : nat -> nat -> nat -> nat) m :=
  \max_(n < m.*2.+1) \max_(k < m.+1) \max_(d < m.*2.+1) limit n k d.

Lemma largest_limit limit (W : lighthouse_world) m : edges W <= m ->
  limit (vertices W) (edges W) (degree (@start W)) <= largest limit m.
Proof.
move=> le; have le2 : #|W| <= m.*2 by rewrite -(edges_double W) leq_double.
have lv : vertices W < m.*2.+1 by rewrite ltnS; apply: leq_trans le2; exact: max_card.
have ld : degree (@start W) < m.*2.+1 by rewrite ltnS; apply: leq_trans le2; exact: max_card.
have lm : edges W < m.+1 by [].
apply: leq_trans (leq_bigmax (Ordinal lv)); apply: leq_trans (leq_bigmax (Ordinal lm)).
exact: (leq_bigmax (F := fun d : 'I__ => limit (vertices W) (edges W) d) (Ordinal ld)).
Qed.

Theorem certificate_exists X limit u m :
  (forall W : lighthouse_world, in_universe u W -> edges W <= m ->
   right_within X (M := rooted (@start W)) (@percept_of W)
     (limit (vertices W) (edges W) (degree (@start W)))) <->
  exists2 b, answers_as X b & certified b limit u m.
Proof.
split=> [H|[b F /certified_right C] W uW le]; last exact: C.
pose os := percepts_to m; pose n := largest limit m.
exists (unrolled_from X os n); first exact: unrolled_answers.
apply/directional_check_correct=> W uW le; have /right_withinE [t [e [z [R V I]]]] := H W uW le.
apply/right_withinE; exists t, e, z; split=> //.
have listed (d : W) : percept_of d \in os by exact: percept_listed.
apply: (@unrolled_explore X os n (rooted (@start W)) (@percept_of W) listed _ n _ _ _ _ _ _
  (largest_limit limit le) _ R).
by rewrite /stands branch_to_map listed.
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
