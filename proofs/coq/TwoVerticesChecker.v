(* ---------------------------------------------------------------------------------------------
   The checker for lighthouses without a direction.                              Sections IV and VIII

   Instances of Checker.v: the cluster of undirected markers in the worlds where exactly one edge joins
   v0 and v1, and the natural lighthouse in the worlds where besides v0 and v1 have degrees of their own.
   v1 lies at the other end of the dart that the world's second number gives.

     cluster_senses, one_edge_in      what is sensed, and which worlds are meant, computed.
     natural_percept d                the degree, and what the robot is told: the degree of v1.
     natural_senses, natural_in       the same for the natural lighthouse.
     natural_kind                     v0 and v1 have degrees of their own, one edge joins them.
     two_vertices_limit n m d0        (1)+(2), two traversals for each test, the search: computed.

     cluster_check_correct, natural_check_correct   what the checker says is so.
     cluster_checked, natural_checked               the two explorers pass, under every policy, for
                                                    every m.
   --------------------------------------------------------------------------------------------- *)
From mathcomp Require Import all_ssreflect.
From Allworlds Require Import Model Maps RootedMaps Codes Explorers NumberedWorlds Algorithm.
From Allworlds Require Import TwoVertices Cluster NaturalLighthouse SameWorld Checker.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Definition pointed_in M k := iter k (nth 0 (sigma_list M)) (root_number M).
Definition cluster_senses M k := cluster_percept_in (seen_from M (pointed_in M k)).
Definition one_edge_in M k := edges_to_v1 (seen_from M (pointed_in M k)) == 1.

Definition natural_percept (W : lighthouse_world) (d : W) := (degree d, degree (alpha (@pointed W))).
Definition natural_senses M k d :=
  (degree_at M d, degree_at M (nth 0 (alpha_list M) (pointed_in M k))).
Definition unique_in M d :=
  all (fun e => (degree_at M e == degree_at M d) ==> same_vertex_in M d e)
    (iota 0 (size (sigma_list M))).
Definition natural_in M k :=
  [&& unique_in M (root_number M), unique_in M (nth 0 (alpha_list M) (pointed_in M k)) &
      one_edge_in M k].
Definition natural_kind (W : lighthouse_world) :=
  [/\ unique (@start W), unique (alpha (@pointed W)) & one_edge W].

Section InNumbers.
Variables (M : numbered_map) (V : valid M) (C : connected (denote M)) (k : nat).
Local Notation W := (world_of_numbers V C k).
Local Notation n := (size (sigma_list M)).

Lemma same_vertex_numbers (i j : in_numbers V C) : same_vertex_in M (val i) (val j) = at_same_vertex i j.
Proof.
have E l : (iter l (nth 0 (sigma_list M)) (val i) == val j) = (iter l sigma i == j).
  by rewrite -val_turn.
apply/hasP/idP=> [[l _]|c]; first by rewrite E => /eqP <-; exact: fconnect_iter.
exists (findex sigma i j); last by rewrite E iter_findex.
rewrite mem_iota /=; apply: leq_trans (findex_max c) _; rewrite -[n](card_ord n); exact: max_card.
Qed.

Lemma pointed_number : pointed_in M k = val (@pointed W).
Proof. by rewrite /pointed_in -[root_number M]/(val (@start W)) -val_turn. Qed.

Lemma v1_number : nth 0 (alpha_list M) (pointed_in M k) = val (alpha (@pointed W)).
Proof. by rewrite pointed_number. Qed.

Lemma cluster_senses_percept (i : W) : cluster_senses M k (val i) = cluster_percept i.
Proof.
rewrite /cluster_senses /cluster_percept_in /= v1_number pointed_number.
rewrite -[degree_at _ _]/(degree_at M (val i)) (degree_in_numbers i).
rewrite -[same_vertex_in _ _ _]/(same_vertex_in M (val (@pointed W)) (val i)).
rewrite -[same_vertex_in (seen_from _ _) _ _]/(same_vertex_in M (val (alpha (@pointed W))) (val i)).
rewrite !same_vertex_numbers /cluster_percept /marks.
by rewrite /at_same_vertex (same_connect (fconnect_sym sigma_inj) (@pointed_at_v0 W)).
Qed.

Lemma one_edgeP : reflect (one_edge W) (one_edge_in M k).
Proof.
pose joins (d : W) := at_same_vertex start d && at_same_vertex (alpha pointed) (alpha d).
have -> : one_edge_in M k = (#|[pred d | joins d]| == 1).
  congr (_ == _); rewrite /edges_to_v1 /= pointed_number -sum1_count -sum1_card.
  have -> : iota 0 n = index_iota 0 n by rewrite /index_iota subn0.
  rewrite big_mkord; apply: eq_bigl => d.
  rewrite /joins inE; congr (_ && _).
    rewrite -[LHS]/(same_vertex_in M (val (@pointed W)) (val (d : W))) same_vertex_numbers.
    by rewrite /at_same_vertex (same_connect (fconnect_sym sigma_inj) (@pointed_at_v0 W)).
  exact: (same_vertex_numbers (alpha (@pointed W)) (alpha (d : W))).
have P : pointed \in [pred d | joins d].
  by rewrite inE /joins pointed_at_v0; exact: connect0.
apply: (iffP idP) => [/card1P[x xE] d c0 c1|H].
  have : d \in [pred d | joins d] by rewrite inE /joins c0.
  by move: P; rewrite !xE !inE => /eqP -> /eqP.
apply/card1P; exists pointed => d; rewrite !inE; apply/andP/eqP=> [[c0 c1]|->]; first exact: H.
by apply/andP.
Qed.

Lemma uniqueP (x : W) : reflect (unique x) (unique_in M (val x)).
Proof.
apply: (iffP allP) => [H d E|H i]; last first.
  rewrite mem_iota => /= li; pose d : W := Ordinal li; rewrite -[i]/(val d).
  by rewrite !degree_in_numbers same_vertex_numbers; apply/implyP=> /eqP; exact: H.
have /implyP := H (val d) (etrans (mem_iota 0 n _) (ltn_ord d)).
by rewrite !degree_in_numbers same_vertex_numbers E eqxx; exact.
Qed.

Lemma natural_senses_percept (i : W) : natural_senses M k (val i) = natural_percept i.
Proof. by rewrite /natural_senses v1_number !degree_in_numbers. Qed.

Lemma natural_kindP : reflect (natural_kind W) (natural_in M k).
Proof.
rewrite /natural_in v1_number -[root_number M]/(val (@start W)).
by apply: (iffP and3P) => [[/uniqueP u0 /uniqueP u1 /one_edgeP]|[/uniqueP u0 /uniqueP u1 /one_edgeP]].
Qed.
End InNumbers.

(* ---- Under other names ---- *)
Section Same.
Variables (W V : lighthouse_world) (f : W -> V).
Hypothesis F : same_world f.
Let fb : bijective f. Proof. by case: F. Qed.
Let fs d : f (sigma d) = sigma (f d). Proof. by case: F. Qed.
Let fa d : f (alpha d) = alpha (f d). Proof. by case: F. Qed.
Let f0 : f start = start. Proof. by case: F. Qed.
Let fp : f pointed = pointed. Proof. by case: F. Qed.

Lemma cluster_percept_same d : cluster_percept (f d) = cluster_percept d.
Proof. by rewrite /cluster_percept /marks -f0 -fp -fa !(same_at_vertex fb fs) (same_degree fb fs). Qed.

Lemma one_edge_same : one_edge W -> one_edge V.
Proof.
move=> H d; have [g _ gK] := fb; rewrite -(gK d) -f0 -fp -!fa !(same_at_vertex fb fs) => c0 c1.
by congr f; exact: H.
Qed.

Lemma natural_percept_same d : natural_percept (f d) = natural_percept d.
Proof. by rewrite /natural_percept -fp -fa !(same_degree fb fs). Qed.

Lemma unique_same x : unique x -> unique (f x).
Proof.
move=> H d; have [g _ gK] := fb; rewrite -(gK d) !(same_degree fb fs) (same_at_vertex fb fs).
exact: H.
Qed.

Lemma natural_kind_same : natural_kind W -> natural_kind V.
Proof.
case=> u0 u1 one; split; last exact: one_edge_same.
  by rewrite -f0; exact: unique_same.
by rewrite -fp -fa; exact: unique_same.
Qed.
End Same.

(* ---- The checkers ---- *)
Definition cluster_check S (r : resumption S (nat * nat)) limit :=
  check r limit cluster_senses one_edge_in.
Definition natural_check S (r : resumption S (nat * nat)) limit :=
  check r limit natural_senses natural_in.

Section Checkers.
Variables (S : Type) (r : resumption S (nat * nat)) (limit : nat -> nat -> nat -> nat).
Local Notation limit_in W := (limit (vertices W) (edges W) (degree (@start W))).

Theorem cluster_check_correct m : cluster_check r limit m <->
  forall W, one_edge W -> edges W <= m ->
  right_within (as_explorer r) (M := rooted (@start W)) (@cluster_percept W) (limit_in W).
Proof.
apply: (@check_correct _ _ r limit _ _ (@cluster_percept) one_edge).
- exact: cluster_percept_same.
- exact: one_edge_same.
- exact: cluster_senses_percept.
exact: one_edgeP.
Qed.

Theorem natural_check_correct m : natural_check r limit m <->
  forall W, natural_kind W -> edges W <= m ->
  right_within (as_explorer r) (M := rooted (@start W)) (@natural_percept W) (limit_in W).
Proof.
apply: (@check_correct _ _ r limit _ _ (@natural_percept) natural_kind).
- exact: natural_percept_same.
- exact: natural_kind_same.
- exact: natural_senses_percept.
exact: natural_kindP.
Qed.
End Checkers.

(* ---- The two explorers pass ---- *)
Definition two_vertices_limit n m d0 := 2 * d0 + (paper_limit n m + 2 * m ^ 2).

Definition cluster_resumption pol : resumption (program (nat * nat) knowledge) (nat * nat) :=
  Resumption (set_out cluster) (act cluster pol) (sense cluster pol).

Theorem cluster_checked pol m : cluster_check (cluster_resumption pol) two_vertices_limit m.
Proof.
apply/cluster_check_correct=> W one _; rewrite /two_vertices_limit paper_limitE.
apply/right_withinE; have [t [e [z [R _ V I]]]] := cluster_correct one pol (leqnn _).
by exists t, e, z.
Qed.

(* the explorer takes its two degrees from the first percept *)
Definition natural_resumption pol :
    resumption (nat * nat * program nat knowledge) (nat * nat) :=
  {| begins := fun o => (o, set_out (natural o.1 o.2) o.1);
     decides := fun s => act (natural s.1.1 s.1.2) pol s.2;
     goes_on := fun s o => (s.1, sense (natural s.1.1 s.1.2) pol s.2 o.1) |}.

Lemma natural_resumptionE pol o seen :
  as_explorer (natural_resumption pol) (o :: seen) = natural_algorithm o.2 pol (o.1 :: unzip1 seen).
Proof.
rewrite /natural_algorithm /=.
suff -> p : foldl (goes_on (natural_resumption pol)) (o, p) seen
    = (o, foldl (sense (natural o.1 o.2) pol) p (unzip1 seen)) by [].
by elim: seen p => //= o' s IH p; exact: IH.
Qed.

(* an explorer that is told b with every percept, and one that has been told it before *)
Lemma episode_told (O T E : Type) (b : T) (X : explorer O E) (Y : explorer (O * T) E)
    (M : rooted_map) (senses : carrier M -> O) budget :
  (forall o seen, Y [seq (q, b) | q <- o :: seen] = X (o :: seen)) ->
  (episode Y M (fun d => (senses d, b)) budget).1.2 = (episode X M senses budget).1.2 /\
  (episode Y M (fun d => (senses d, b)) budget).2 = (episode X M senses budget).2.
Proof.
move=> YX; rewrite /episode; move: (root M) => d; rewrite -[[:: (_, b)]]/([seq (q, b) | q <- [:: senses d]]).
move: (senses d) [::] => o seen.
elim: budget seen d => [|fuel IH] seen d; rewrite /= -[Y _]/(Y [seq (q, b) | q <- o :: seen]) YX.
  by case: (X _).
case: (X _) => // k; have := IH (rcons seen (senses (motion_in M k d))) (motion_in M k d).
rewrite /= map_rcons.
by case: (explore X _ _ _ _ _) => [[t a] z]; case: (explore Y _ _ _ _ _) => [[t' a'] z'].
Qed.

Theorem natural_checked pol m : natural_check (natural_resumption pol) two_vertices_limit m.
Proof.
apply/natural_check_correct=> W [u0 u1 one] _; rewrite /two_vertices_limit paper_limitE.
have [t [e [z [R _ V I]]]] := natural_correct u0 u1 one pol (leqnn _).
set b := degree (alpha (@pointed W)) in R *.
have told o seen : as_explorer (natural_resumption pol) [seq (q, b) | q <- o :: seen]
    = natural_algorithm b pol (o :: seen).
  rewrite -[map _ _]/((o, b) :: [seq (q, b) | q <- seen]) natural_resumptionE.
  by congr (natural_algorithm _ _ (_ :: _)); rewrite /unzip1 -map_comp map_id_in.
have := @episode_told _ _ _ b _ _ (rooted (@start W)) (@degree W)
  (2 * degree (@start W) + cluster_bound W) told.
rewrite R /= -[fun d => (degree d, b)]/(@natural_percept W) => -[].
case E: (episode _ _ _ _) => [[t' a] z'] /= A Z; subst a z'.
by apply/right_withinE; exists t', e, z.
Qed.
