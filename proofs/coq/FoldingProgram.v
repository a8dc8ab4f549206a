(* ---------------------------------------------------------------------------------------------
   Folding, computed: the log of a robot as the map that it proves.                  Sections IV, V

   The darts of a log (Log.v) are numbered: those of the start vertex, from the dart that the robot
   faces, then those of each arrival, from the dart by which it came in.

     dart_number L p      the number of the log dart p.
     next_in L, links_in L, marked_in L   what CongruenceProgram.v needs.
     labels L             for each number the least number of a dart that is the same dart.
     folds L              no dart is open.
     folded_map L         one dart for each class: the folded log.  An open dart is its own other end.
                          The root is the dart in which the robot is at the end.

     labels_same          equal labels, if and only if same_dart: the least congruence.
     folds_no_open_dart   folds L, if and only if no_open_dart L.
     same_place           no open dart: darts of the log are the same if and only if they are one dart
                          of a world that agrees with the log.
     folded_map_is_the_world   no open dart: folded_map L is the world that agrees with the log, seen
                          from where the robot is.
     unfolded_refutes     an explorer that stops with an open dart does not find all maps.
   --------------------------------------------------------------------------------------------- *)
From mathcomp Require Import all_ssreflect.
From Allworlds Require Import Model Maps Percepts RootedMaps Codes Explorers Congruence Log.
From Allworlds Require Import Folding OpenDarts CongruenceProgram.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(* ---- The program ---- *)
Definition sizes L := [seq p.1.-1.+1 | p <- percepts L].

Definition next_in L :=
  let s := sizes L in
  flatten [seq [seq flatten_index s i (j.+1 %% nth 0 s i) | j <- iota 0 (nth 0 s i)]
          | i <- iota 0 (size s)].
Definition links_in L :=
  let s := sizes L in
  flatten [seq let a := flatten_index s i (nth 0 (motions L) i %% nth 0 s i) in
               let b := flatten_index s i.+1 0 in [:: (a, b); (b, a)]
          | i <- iota 0 (size (steps L))].
Definition marked_in L :=
  let s := sizes L in
  pmap id [seq omap (fun b => flatten_index s i (b %% nth 0 s i))
                    (nth (first_percept L) (percepts L) i).2
          | i <- iota 0 (size s)].

Definition labels L := classes (next_in L) (links_in L) (marked_in L).
Definition folds_by links c := all (settled_in links c) (iota 0 (size c)).
Definition folds L := folds_by (links_in L) (labels L).

Definition map_of_labels next links (c : seq nat) here :=
  let darts := [seq x <- iota 0 (size c) | nth 0 c x == x] in
  let number x := index (nth 0 c x) darts in
  let ends x := if [seq l <- links | nth 0 c l.1 == x] is l :: _ then l.2 else x in
  NumberedMap [seq number (nth 0 next x) | x <- darts] [seq number (ends x) | x <- darts]
    (number here).
Definition folded_map L :=
  map_of_labels (next_in L) (links_in L) (labels L) (flatten_index (sizes L) (size (steps L)) 0).

(* ---- The numbering ---- *)
Section Log.
Variable L : log.
Local Notation N := (size (steps L)).
Local Notation n := (sumn (sizes L)).

Definition dart_number (p : log_dart L) := flatten_index (sizes L) (tag p) (val (tagged p)).

Lemma size_sizes : size (sizes L) = N.+1.
Proof. by rewrite /sizes /= !size_map. Qed.

Lemma nth_sizes i : i <= N -> nth 0 (sizes L) i = darts_at L i.
Proof. by move=> li; rewrite (nth_map (first_percept L)) // /percepts /= size_map ltnS. Qed.

Lemma tag_small (p : log_dart L) : tag p <= N.
Proof. by rewrite -ltnS. Qed.

Lemma tagged_small (p : log_dart L) : val (tagged p) < nth 0 (sizes L) (tag p).
Proof. by rewrite (nth_sizes (tag_small p)); exact: ltn_ord. Qed.

Lemma dart_number_small p : dart_number p < n.
Proof. exact/flatten_indexP/tagged_small. Qed.

Lemma dart_number_at i j : i <= N ->
  dart_number (dart_at L i j) = flatten_index (sizes L) i (j %% nth 0 (sizes L) i).
Proof. by move=> li; rewrite nth_sizes // /dart_number /= inordK ?ltnS. Qed.

Lemma dart_number_inj : injective dart_number.
Proof.
move=> p q E; rewrite (dart_atP p) (dart_atP q).
have := congr1 (reshape_index (sizes L)) E; have := congr1 (reshape_offset (sizes L)) E.
by rewrite !flatten_indexKl ?flatten_indexKr ?tagged_small // => -> ->.
Qed.

Lemma dart_number_onto i : i < n -> exists p, dart_number p = i.
Proof.
move=> li; have lr := reshape_indexP li; have lo := reshape_offsetP li.
exists (dart_at L (reshape_index (sizes L) i) (reshape_offset (sizes L) i)).
rewrite size_sizes ltnS in lr; rewrite dart_number_at // modn_small //; exact: reshape_indexK.
Qed.

Lemma shape_next : shape [seq [seq flatten_index (sizes L) i (j.+1 %% nth 0 (sizes L) i)
    | j <- iota 0 (nth 0 (sizes L) i)] | i <- iota 0 (size (sizes L))] = sizes L.
Proof.
apply: (@eq_from_nth _ 0) => [|i]; first by rewrite !size_map size_iota.
rewrite !size_map size_iota => li; rewrite (nth_map [::]) ?size_map ?size_iota //.
by rewrite (nth_map 0) ?size_iota // nth_iota // size_map size_iota.
Qed.

Lemma size_next : size (next_in L) = n.
Proof. by rewrite size_flatten shape_next. Qed.

Lemma next_number p : nth 0 (next_in L) (dart_number p) = dart_number (next_dart p).
Proof.
have lt := tagged_small p; have li : tag p < size (sizes L) by rewrite size_sizes ltnS tag_small.
rewrite dart_number_at ?tag_small // nth_flatten shape_next flatten_indexKl ?flatten_indexKr //.
by rewrite (nth_map 0) ?size_iota // nth_iota // (nth_map 0) ?size_iota // nth_iota.
Qed.

Lemma links_number p q : crossed p q <-> (dart_number p, dart_number q) \in links_in L.
Proof.
have num i : i < N -> (dart_number (crossing L i).1, dart_number (crossing L i).2) =
    (flatten_index (sizes L) i (nth 0 (motions L) i %% nth 0 (sizes L) i), flatten_index (sizes L) i.+1 0).
  by move=> li; rewrite !dart_number_at ?(ltnW li) // mod0n.
split=> [/hasP[i]|/flattenP[s /mapP[i]]]; rewrite mem_iota => /= li.
  move=> c; apply/flattenP; eexists; first by apply: (@map_f _ _ _ _ i); rewrite mem_iota.
  have [<- <-] := num i li; case/orP: c => /eqP[-> ->]; rewrite !inE ?eqxx ?orbT //.
move=> ->; have [<- <-] := num i li => m; apply/hasP; exists i; rewrite ?mem_iota //.
by move: m; rewrite !inE => /orP[] /eqP[/dart_number_inj -> /dart_number_inj ->]; rewrite eqxx ?orbT.
Qed.

Lemma links_small : all (in_range n) (links_in L).
Proof.
apply/allP=> p /flattenP[s /mapP[i]]; rewrite mem_iota => /= li ->.
have a : flatten_index (sizes L) i (nth 0 (motions L) i %% nth 0 (sizes L) i) < n.
  by rewrite -(dart_number_at _ (ltnW li)); exact: dart_number_small.
have b : flatten_index (sizes L) i.+1 0 < n.
  by have := dart_number_small (dart_at L i.+1 0); rewrite dart_number_at // mod0n.
by rewrite !inE => /orP[] /eqP->; rewrite /in_range /= a b.
Qed.

Lemma mem_marked x : x \in marked_in L <->
  exists i b, [/\ i <= N, (percept_at L i).2 = Some b & x = dart_number (dart_at L i b)].
Proof.
rewrite mem_pmap map_id; split=> [/mapP[i]|[i [b [li E ->]]]].
  rewrite mem_iota size_sizes add0n ltnS => /= li; rewrite -/(percept_at L i).
  by case E: (percept_at L i).2 => [b|] //= [->]; exists i, b; rewrite dart_number_at.
apply/mapP; exists i; first by rewrite mem_iota size_sizes ltnS.
by rewrite -/(percept_at L i) E /= dart_number_at.
Qed.

Lemma marked_number p : sensed_pointed p <-> dart_number p \in marked_in L.
Proof.
rewrite mem_marked; split=> [/hasP[i]|[i [b [li E]]]].
  rewrite mem_iota ltnS => /= li; case E: (percept_at L i).2 => [b|] // /eqP->; by exists i, b.
by move/dart_number_inj->; apply/hasP; exists i; rewrite ?mem_iota ?ltnS // E.
Qed.

Lemma marked_small : all (gtn n) (marked_in L).
Proof. by apply/allP=> x /mem_marked[i [b [_ _ ->]]]; exact: dart_number_small. Qed.

Local Notation c := (labels L).

Theorem labels_same p q :
  (nth 0 c (dart_number p) == nth 0 c (dart_number q)) = same_dart p q.
Proof.
apply: classes_same; rewrite ?size_next.
- exact: dart_number_inj.
- exact: dart_number_small.
- exact: dart_number_onto.
- exact: next_number.
- exact: links_number.
- exact: links_small.
- exact: marked_number.
exact: marked_small.
Qed.

Lemma labels_least : least_labels n c.
Proof.
rewrite -size_next; apply: (@classes_least _ (@next_dart L) dart_number); rewrite ?size_next.
- exact: dart_number_small.
- exact: dart_number_onto.
- exact: next_number.
- exact: links_small.
exact: marked_small.
Qed.

Theorem settled_in_number p : settled_in (links_in L) c (dart_number p) = dart_settled p.
Proof.
apply: settled_in_settled; rewrite ?size_next.
- exact: dart_number_inj.
- exact: dart_number_small.
- exact: dart_number_onto.
- exact: next_number.
- exact: links_number.
- exact: links_small.
- exact: marked_number.
exact: marked_small.
Qed.

Theorem folds_no_open_dart : folds L <-> no_open_dart L.
Proof.
have sz := labels_least.1; split=> [/allP H p|H].
  by rewrite -settled_in_number; apply: H; rewrite mem_iota sz dart_number_small.
apply/allP=> i; rewrite mem_iota sz => /= /dart_number_onto[p <-].
by rewrite settled_in_number.
Qed.

(* ---- Without open dart the folded map is the world ---- *)
Section World.
Variable W : lighthouse_world.
Hypotheses (A : agrees W L) (nopen : no_open_dart L).
Local Notation place := (@place L W).

(* a world in which darts of the log are one dart only if the folding says so *)
Theorem same_place p q : same_dart p q <-> place p = place q.
Proof.
split=> [|E]; first exact: folding_sound.
have A' := completed_agrees A (@inj_id unit) (fun t => erefl) leaf_end leaf_connected.
have [f [_ fs _ _ fr]] := folding_determines A A' nopen.
have fP r : f (place r) = old A (@inj_id unit) (fun t => erefl) leaf_end leaf_connected r.
  have lr := tag_small r; rewrite /Log.place.
  have -> k x : f (iter k sigma x) = iter k sigma (f x) by elim: k => //= k <-; exact: fs.
  by rewrite fr // /robot_at old_robot // old_turn_at // -dart_atP.
by have := congr1 f E; rewrite !fP => /eqP; rewrite oldE.
Qed.

(* the dart of the world that has number i *)
Definition number_place i :=
  place (dart_at L (reshape_index (sizes L) i) (reshape_offset (sizes L) i)).

Lemma number_placeE p : number_place (dart_number p) = place p.
Proof.
by rewrite /number_place flatten_indexKl ?flatten_indexKr ?tagged_small // -dart_atP.
Qed.

Lemma number_place_label i : i < n -> number_place (nth 0 c i) = number_place i.
Proof.
move=> li; have [p pE] := dart_number_onto li; have lc := label_small labels_least li.
have [q qE] := dart_number_onto lc; rewrite -{1}qE -pE !number_placeE; apply/same_place.
by rewrite -labels_same qE pE; have [_ ->] := labels_least.2 i li.
Qed.

Lemma number_place_inj i j : i < n -> j < n -> number_place i = number_place j ->
  nth 0 c i = nth 0 c j.
Proof.
move=> /dart_number_onto[p <-] /dart_number_onto[q <-]; rewrite !number_placeE => E.
by apply/eqP; rewrite labels_same; apply/same_place.
Qed.

Lemma number_place_next i : i < n -> number_place (nth 0 (next_in L) i) = sigma (number_place i).
Proof. by case/dart_number_onto=> p <-; rewrite next_number !number_placeE place_next. Qed.

Lemma number_place_link l : l \in links_in L -> number_place l.2 = alpha (number_place l.1).
Proof.
move=> m; have /andP[l1 l2] := allP links_small _ m.
have [p pE] := dart_number_onto l1; have [q qE] := dart_number_onto l2.
rewrite -pE -qE !number_placeE; apply: (place_crossed A); apply/links_number.
by rewrite pE qE -surjective_pairing.
Qed.

Lemma number_place_onto x : exists2 i, i < n & number_place i = x.
Proof.
have [p <-] := place_onto A nopen x; exists (dart_number p); last exact: number_placeE.
exact: dart_number_small.
Qed.

Local Notation darts := [seq x <- iota 0 (size c) | nth 0 c x == x].
Local Notation number x := (index (nth 0 c x) darts).

Lemma mem_darts x : (x \in darts) = (x < n) && (nth 0 c x == x).
Proof. by rewrite mem_filter mem_iota labels_least.1 andbC. Qed.

Lemma label_in_darts x : x < n -> nth 0 c x \in darts.
Proof.
by move=> lx; have [_ E] := labels_least.2 x lx; rewrite mem_darts E eqxx (label_small labels_least).
Qed.

Lemma nth_number x : x < n -> nth 0 darts (number x) = nth 0 c x.
Proof. by move=> lx; rewrite nth_index ?label_in_darts. Qed.

(* the first known end of a dart *)
Lemma ends_at x : x \in darts -> exists l, [/\ l \in links_in L, nth 0 c l.1 = x &
  (if [seq l <- links_in L | nth 0 c l.1 == x] is l' :: _ then l'.2 else x) = l.2].
Proof.
rewrite mem_darts => /andP[lx /eqP cx]; have [p pE] := dart_number_onto lx.
have := nopen p; rewrite -settled_in_number pE => /hasP[l ml]; rewrite cx => cl.
case E: [seq l <- links_in L | nth 0 c l.1 == x] => [|l' s].
  by have : l \in [::] by rewrite -E mem_filter cl.
have : l' \in links_in L /\ nth 0 c l'.1 = x; last by case; exists l'.
by have := mem_head l' s; rewrite -E mem_filter => /andP[/eqP].
Qed.

Theorem folded_map_is_the_world : valid (folded_map L) /\
  isomorphic (denote (folded_map L)) (rooted (@robot_at L W N)).
Proof.
pose M := folded_map L.
have here_small : flatten_index (sizes L) N 0 < n.
  by have := dart_number_small (dart_at L N 0); rewrite dart_number_at // mod0n.
have dk k : k < size darts -> nth 0 darts k \in darts by exact: mem_nth.
have dn x : x \in darts -> x < n by rewrite mem_darts => /andP[].
have sz : size (sigma_list M) = size darts by rewrite size_map.
have I : isomorphic (denote M) (rooted (@robot_at L W N)).
  exists (fun k => number_place (nth 0 darts k)).
  pose pre (x : W) := odflt (dart_at L 0 0) [pick p | place p == x].
  have preP x : place (pre x) = x.
    rewrite /pre; case: pickP => [p /eqP //|H]; have [p e] := place_onto A nopen x.
    by have := H p; rewrite e eqxx.
  exists (fun x => number (dart_number (pre x))); split.
  - move=> k; rewrite [is_dart _ _]/= sz => lk; have mk := dk k lk; have lx := dn _ mk.
    split=> //.
    + have E : nth 0 c (dart_number (pre (number_place (nth 0 darts k)))) = nth 0 c (nth 0 darts k).
        by apply: number_place_inj => //; [exact: dart_number_small | rewrite number_placeE preP].
      rewrite E; move: mk; rewrite mem_darts => /andP[_ /eqP ->].
      by rewrite index_uniq ?filter_uniq ?iota_uniq.
    + rewrite /= (nth_map 0) // nth_number ?number_place_label ?number_place_next //.
        by have /dart_number_onto[p <-] := lx; rewrite next_number dart_number_small.
      by have /dart_number_onto[p <-] := lx; rewrite next_number dart_number_small.
    rewrite /= (nth_map 0) //; have [l [ml cl ->]] := ends_at mk.
    have /andP[l1 l2] := allP links_small _ ml.
    rewrite nth_number // number_place_label // number_place_link //.
    by rewrite -(number_place_label l1) cl.
  - move=> x _; split.
      by rewrite /= size_map index_mem label_in_darts ?dart_number_small.
    by rewrite nth_number ?number_place_label ?dart_number_small // number_placeE preP.
  rewrite [root _]/= nth_number // number_place_label //.
  have -> : flatten_index (sizes L) N 0 = dart_number (dart_at L N 0).
    by rewrite dart_number_at // mod0n.
  by rewrite number_placeE place_at.
split=> //; apply: validI; last by rewrite /= !size_map.
apply: (isomorphic_wellformed I (rooted_wellformed _)); rewrite [is_dart _]/= sz.
- by rewrite index_mem label_in_darts.
- move=> k lk; rewrite /= (nth_map 0) // index_mem label_in_darts //.
  by have /dart_number_onto[p <-] := dn _ (dk k lk); rewrite next_number dart_number_small.
move=> k lk; rewrite /= (nth_map 0) // index_mem label_in_darts //.
by have [l [ml _ ->]] := ends_at (dk k lk); have /andP[] := allP links_small _ ml.
Qed.
End World.
End Log.

(* an explorer that stops with an open dart does not find all maps: of all worlds, or of all simple ones *)
Theorem unfolded_refutes u E (meaning : E -> rooted_map) (X : explorer percept E) (W : lighthouse_world) :
  in_universe u W -> forall budget t e z,
  episode X (rooted (@start W)) (@percept_of W) budget = (t, Some e, z) ->
  ~~ folds (log_of W t) -> ~ finds_all_maps u meaning X.
Proof.
move=> uW budget t e z R N H; case/negP: N; apply/folds_no_open_dart.
exact: (explorer_log_folds H uW R).
Qed.
