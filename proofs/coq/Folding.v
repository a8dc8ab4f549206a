(* ---------------------------------------------------------------------------------------------
   Folding: the log of a robot with a directional lighthouse is a proof of the map.   Sections IV, V

   The log holds the motions made and the percepts sensed, nothing else.  Each arrival begins as a
   vertex of its own, of the degree that was sensed.  Then whatever has to be the same is made the
   same: at every sensing of the marker the pointed dart is one and the same dart; darts that are the
   same have the same next dart clockwise; and the same other end.

     log                  the first percept, then the (motion, percept) pairs.
     agrees W L           the motions of L, made in W, give the percepts of L.
     log_dart L           (i, j): the j-th dart clockwise from the robot's dart after motion i.
     next_dart p          the next one clockwise.
     crossed p q          a motion of the log leaves by p and arrives by q, or the other way round.
     sensed_pointed p     a percept of the log says that the marker points along p.
     place W p            the dart of W that p is, when W agrees with the log.

     congruence R         R is an equivalence kept by next_dart and by crossing an edge, in which the
                          pointed darts are all related.
     same, same_dart      the least congruence: x and y are the same if every congruence says so.
     glued p q            the folding knows q as the other end of the edge of p.
     dart_settled p       the folding knows the other end of p.  Otherwise p is open.
     no_open_dart L       all darts of the log are settled.
     folded               the folded log: one dart for each class of log darts.
     completion           a map in which every dart without other end has been given one, by a copy of
                          a small piece T; with_leaves, with_loops: the two completions of the folded
                          log by vertices of degree 1, and by vertices of degree 3 with a loop.

     folding_sound        what the folding proves holds in every world that agrees with the log:
     folding_sound_ends   the same darts are one dart, and glued darts are the two ends of an edge.
     folding_determines   no open dart: any two worlds that agree with the log are the same, by a
                          bijection that keeps the marker and the whole way of the robot.
     open_dart_two_worlds an open dart: two worlds agree with the log that have different numbers of
                          edges.
     no_open_dart_iff     both together, for a log with which some world agrees.
     right_everywhere     the explorer is right in all worlds with a directional lighthouse.
     right_explorer_log_folds   then its log, in whatever world, leaves no dart open.
   --------------------------------------------------------------------------------------------- *)
From mathcomp Require Import all_ssreflect.
From Allworlds Require Import Maps Percepts RootedMaps Explorers.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

(* ---- The least congruence ---- *)
Section Gluing.
Variables (D : finType) (next : D -> D) (linked : rel D) (marked : pred D).
Implicit Types (x y z : D).

Record congruence (R : rel D) : Prop := Congruence {
  congruence_refl : forall x, R x x;
  congruence_sym : forall x y, R x y -> R y x;
  congruence_trans : forall y x z, R x y -> R y z -> R x z;
  congruence_next : forall x y, R x y -> R (next x) (next y);
  congruence_link : forall x y x' y', R x y -> linked x x' -> linked y y' -> R x' y';
  congruence_mark : forall x y, marked x -> marked y -> R x y }.

Definition is_congruence (R : rel D) :=
  [&& [forall x, R x x],
      [forall x, forall y, R x y ==> R y x],
      [forall y, forall x, forall z, R x y ==> R y z ==> R x z],
      [forall x, forall y, R x y ==> R (next x) (next y)],
      [forall x, forall y, forall x', forall y',
         R x y ==> linked x x' ==> linked y y' ==> R x' y'] &
      [forall x, forall y, marked x ==> marked y ==> R x y]].

Lemma congruenceP R : reflect (congruence R) (is_congruence R).
Proof.
apply: (iffP idP) => [|[H1 H2 H3 H4 H5 H6]].
  case/and5P=> /forallP H1 /forallP H2 /forallP H3 /forallP H4 /andP[/forallP H5 /forallP H6].
  split=> //.
  - by move=> x y; have /forallP/(_ y)/implyP := H2 x.
  - by move=> y x z; have /forallP/(_ x)/forallP/(_ z)/implyP H := H3 y => /H/implyP.
  - by move=> x y; have /forallP/(_ y)/implyP := H4 x.
  - move=> x y x' y'; have /forallP/(_ y)/forallP/(_ x')/forallP/(_ y')/implyP H := H5 x.
    by move=> /H/implyP{}H /H/implyP.
  by move=> x y; have /forallP/(_ y)/implyP H := H6 x => /H/implyP.
apply/and5P; split; [| | | |apply/andP; split]; apply/forallP=> x //.
- by apply/forallP=> y; apply/implyP; exact: H2.
- by do 2 apply/forallP=> ?; apply/implyP=> ?; apply/implyP; exact: H3.
- by apply/forallP=> y; apply/implyP; exact: H4.
- by do 3 apply/forallP=> ?; apply/implyP=> h1; apply/implyP=> h2; apply/implyP; exact: H5 h1 h2.
by apply/forallP=> ?; apply/implyP=> ?; apply/implyP; exact: H6.
Qed.

Definition same : rel D := fun x y =>
  [forall R : {set D * D}, is_congruence (fun u v => (u, v) \in R) ==> ((x, y) \in R)].

Lemma sameP x y :
  reflect (forall R : {set D * D}, congruence (fun u v => (u, v) \in R) -> (x, y) \in R) (same x y).
Proof.
apply: (iffP forallP) => H R; first by move/congruenceP; apply/implyP.
by apply/implyP=> /congruenceP; exact: H.
Qed.

Theorem same_least (R : rel D) x y : congruence R -> same x y -> R x y.
Proof.
case=> H1 H2 H3 H4 H5 H6 /sameP/(_ [set p | R p.1 p.2]); rewrite inE; apply.
split=> [u|u v|v u w|u v|u v u' v'|u v]; rewrite !inE //=;
  [exact: H2|exact: H3|exact: H4|exact: H5|].
exact: H6.
Qed.

Theorem same_congruence : congruence same.
Proof.
split.
- by move=> x; apply/sameP=> R [].
- by move=> x y /sameP H; apply/sameP=> R C; apply: (congruence_sym C); exact: H.
- move=> y x z /sameP H /sameP K; apply/sameP=> R C.
  by apply: (congruence_trans C) (H R C) (K R C).
- by move=> x y /sameP H; apply/sameP=> R C; apply: (congruence_next C); exact: H.
- move=> x y x' y' /sameP H l l'; apply/sameP=> R C.
  by apply: (congruence_link C) (H R C) l l'.
by move=> x y mx my; apply/sameP=> R C; exact: (congruence_mark C).
Qed.

Let refl := congruence_refl same_congruence.
Let sym := congruence_sym same_congruence.
Let trans := congruence_trans same_congruence.

Definition glued x y := [exists x', same x x' && linked x' y].
Definition settled x := [exists y, glued x y].

Lemma gluedP x y : reflect (exists2 x', same x x' & linked x' y) (glued x y).
Proof. by apply: (iffP existsP) => [[x' /andP[s l]]|[x' s l]]; exists x'; rewrite ?s. Qed.

Lemma glued_same x y u v : same x y -> glued x u -> glued y v -> same u v.
Proof.
move=> s /gluedP[x' sx lx] /gluedP[y' sy ly].
apply: (congruence_link same_congruence) lx ly; apply: trans (sym sx) _.
exact: trans s sy.
Qed.

(* ---- The folded log: darts that are the same are one ---- *)
Definition representative x := odflt x [pick y | same x y].

Lemma same_representative x : same x (representative x).
Proof. by rewrite /representative; case: pickP => //= _; exact: refl. Qed.

Lemma representative_eq x y : same x y -> representative x = representative y.
Proof.
move=> s; rewrite /representative (@eq_pick _ (same x) (same y)); last first.
  by move=> z; apply/idP/idP=> h; [exact: trans (sym s) h | exact: trans s h].
by case: pickP => // /(_ y); rewrite refl.
Qed.

Lemma representative_idem x : representative (representative x) == representative x.
Proof. by rewrite -(representative_eq (same_representative x)). Qed.

Definition folded := [finType of {x : D | representative x == x}].
Definition fold x : folded :=
  exist (fun y => representative y == y) (representative x) (representative_idem x).

Lemma foldE x y : (fold x == fold y) = same x y.
Proof.
apply/eqP/idP=> [/(congr1 val) /= E|s]; last by apply: val_inj; exact: representative_eq.
by apply: trans (same_representative x) _; rewrite E; apply: sym; exact: same_representative.
Qed.

Lemma fold_val (f : folded) : fold (val f) = f.
Proof. by apply: val_inj; case: f => x /= /eqP. Qed.

Definition folded_next (f : folded) := fold (next (val f)).
Definition folded_end (f : folded) := omap fold [pick y | glued (val f) y].

Lemma folded_nextE x : folded_next (fold x) = fold (next x).
Proof.
apply/eqP; rewrite foldE; apply: (congruence_next same_congruence).
by apply: sym; exact: same_representative.
Qed.

Lemma folded_iter k x : iter k folded_next (fold x) = fold (iter k next x).
Proof. by elim: k => //= k ->; rewrite folded_nextE. Qed.

Lemma folded_endP f g : reflect (exists x y, [/\ fold x = f, fold y = g & linked x y])
  (folded_end f == Some g).
Proof.
apply: (iffP eqP); rewrite /folded_end.
  case: pickP => //= y /gluedP[x s l] [E]; exists x, y; split=> //.
  by rewrite -(fold_val f); apply/eqP; rewrite foldE; exact: sym.
case=> x [y [E E' l]].
have s : same x (val f) by rewrite -foldE E fold_val.
have o : glued (val f) y by apply/gluedP; exists x => //; exact: sym.
case: pickP => [z oz|/(_ y)]; last by rewrite o.
by rewrite /= -E'; congr Some; apply/eqP; rewrite foldE; exact: glued_same (refl _) oz o.
Qed.

Lemma folded_end_none x : (folded_end (fold x) == None) = ~~ settled x.
Proof.
rewrite /folded_end; case: pickP => [y /gluedP[x' s l]|N] /=.
  suff -> : settled x by [].
  apply/existsP; exists y; apply/gluedP; exists x' => //.
  exact: trans (same_representative x) s.
suff -> : settled x = false by [].
apply/existsP=> -[y /gluedP[x' s l]]; have /negP[] := negbT (N y); apply/gluedP.
by exists x' => //; apply: trans s; apply: sym; exact: same_representative.
Qed.
End Gluing.

(* ---- Worlds with places where edges are missing, and their completions ---- *)

(* two turns from x and from y agree in what they meet: then so do the percepts *)
Lemma order_least (T : finType) (f : T -> T) x n : injective f -> 0 < n -> iter n f x = x ->
  (forall j, 0 < j < n -> iter j f x <> x) -> order f x = n.
Proof.
move=> fi n0 E H; apply/eqP; rewrite eqn_leq; apply/andP; split; rewrite leqNgt; apply/negP=> lt.
  have := findex_iter lt; rewrite E findex0 => e0; by rewrite -e0 in n0.
by apply: (H (order f x)); rewrite ?order_gt0 // iter_order.
Qed.

Lemma percept_transfer (W W' : lighthouse_world) (d : W) (d' : W') :
  (forall j, (iter j sigma d' == d') = (iter j sigma d == d)) ->
  (forall j, (iter j sigma d' == pointed) = (iter j sigma d == pointed)) ->
  percept_of d' = percept_of d.
Proof.
move=> H P; have E : degree d' = degree d.
  apply: order_least; [exact: sigma_inj | exact: degree_gt0 | |].
    by apply/eqP; rewrite H iter_degree.
  move=> j /andP[j0 lj]; apply/eqP; rewrite H; apply/eqP=> F.
  by have := findex_iter lj; rewrite F findex0 => e0; rewrite -e0 in j0.
rewrite /percept_of E /bearing; congr (_, _).
have C : at_same_vertex d' pointed = at_same_vertex d pointed.
  by apply/idP/idP=> /iter_findex /eqP; [rewrite P|rewrite -P] => /eqP <-; exact: fconnect_iter.
rewrite C; case: ifP => // c; have := iter_findex c => /eqP; rewrite -P => /eqP <-.
by rewrite findex_iter // -/(degree d') E; exact: findex_max.
Qed.

Section Completion.
Variables (F : finType) (s : F -> F) (o : F -> option F).
Hypotheses (s_inj : injective s) (o_sym : forall x y, o x = Some y -> o y = Some x).
Hypothesis o_neq : forall x, o x <> Some x.
Hypothesis conn : forall x y, connect (fun u v => (v == s u) || (o u == Some v)) x y.
Variables (T : finType) (sT aT : T -> T) (stem : T).
Hypotheses (sT_inj : injective sT) (aTK : involutive aT).
Hypothesis aT_stem : forall t, (aT t == t) = (t == stem).
Hypothesis connT : forall t, connect (adjacent sT aT) stem t.

Definition loose := [finType of {x : F | o x == None}].
Definition as_loose x (e : o x == None) : loose := exist (fun y => o y == None) x e.
Definition completed := (F + loose * T)%type.
Definition completed_sigma (d : completed) : completed :=
  match d with inl x => inl (s x) | inr (l, t) => inr (l, sT t) end.
Definition completed_alpha (d : completed) : completed :=
  match d with
  | inl x => match insub x with
             | Some l => inr (l, stem)
             | None => inl (odflt x (o x))
             end
  | inr (l, t) => if t == stem then inl (val l) else inr (l, aT t)
  end.

Lemma completed_alpha_glued x y : o x = Some y -> completed_alpha (inl x) = inl y.
Proof. by move=> E /=; rewrite insubN E. Qed.

Lemma completed_sigma_inj : injective completed_sigma.
Proof. by move=> [x|[l t]] [y|[l' t']] //= [] => [/s_inj -> //|-> /sT_inj -> //]. Qed.

Lemma completed_alphaK : involutive completed_alpha.
Proof.
have stemE : aT stem = stem by apply/eqP; rewrite aT_stem.
move=> [x|[l t]] /=.
  case: insubP => [l _ <-|]; first by rewrite /= eqxx.
  by case E: (o x) => [y|] //= _; exact: completed_alpha_glued (o_sym E).
case: (t =P stem) => [->|/eqP ne] /=; first by rewrite valK.
have -> : (aT t == stem) = false; last by rewrite aTK.
by apply/negbTE/eqP=> E; move: ne; rewrite -aT_stem -{2}(aTK t) E stemE eqxx.
Qed.

Lemma completed_alpha_neq d : completed_alpha d != d.
Proof.
case: d => [x|[l t]] /=; last first.
  case: (t =P stem) => // /eqP; rewrite -aT_stem; apply: contra => /eqP[->] //.
case: insubP => [l _ _|] //; case E: (o x) => [y|] //= _.
by apply/eqP=> -[yx]; apply: (o_neq (x := x)); rewrite E yx.
Qed.

Lemma completed_connected x y : connect (adjacent completed_sigma completed_alpha) x y.
Proof.
set adj := adjacent _ _.
have stepa d : connect adj d (completed_alpha d) by apply: connect1;
  rewrite /adj /adjacent eqxx orbT.
have old u v : connect adj (inl u) (inl v).
  case/connectP: (conn u v) => p + ->; elim: p u => //= w p IH u /andP[H /IH]; apply: connect_trans.
  case/orP: H => /eqP H; first by rewrite H; apply: connect1; rewrite /adj /adjacent /= eqxx.
  by rewrite -(completed_alpha_glued H).
have out l t : connect adj (inl (val l)) (inr (l, t)).
  apply: (@connect_trans _ _ (inr (l, stem))).
    by have := stepa (inl (val l)); rewrite /= valK.
  case/connectP: (connT t) => p + ->; elim: p (stem) => //= w p IH u /andP[H /IH];
    apply: connect_trans.
  case/orP: H => /eqP->; first by apply: connect1; rewrite /adj /adjacent /= eqxx.
  case: (u =P stem) => [->|/eqP ne]; first by have /eqP-> : aT stem == stem by rewrite aT_stem.
  by have := stepa (inr (l, u)); rewrite /= (negbTE ne).
have back l t : connect adj (inr (l, t)) (inl (val l)).
  by rewrite /adj (adjacent_connect_sym completed_sigma_inj completed_alphaK); exact: out.
case: x y => [x|[l t]] [y|[l' t']].
- exact: old.
- exact: connect_trans (old x (val l')) (out l' t').
- exact: connect_trans (back l t) (old (val l) y).
exact: connect_trans (back l t) (connect_trans (old (val l) (val l')) (out l' t')).
Qed.

Definition completion :=
  CombinatorialMap completed_sigma_inj completed_alphaK completed_alpha_neq completed_connected.

Lemma card_completion : #|completion| = #|F| + #|loose| * #|T|.
Proof. by rewrite card_sum card_prod. Qed.

End Completion.

(* ---- The log ---- *)
Record log := Log { first_percept : percept; steps : seq (nat * percept) }.

Definition motions L := unzip1 (steps L).
Definition percepts L := first_percept L :: unzip2 (steps L).
Definition agrees (W : lighthouse_world) L := percepts_along (motions L) (@start W) = percepts L.

Section Log.
Variable L : log.
Local Notation N := (size (steps L)).

Definition percept_at i := nth (first_percept L) (percepts L) i.
Definition motion_at i := nth 0 (motions L) i.
Definition darts_at i := (percept_at i).1.-1.+1.

Definition log_dart := [finType of {i : 'I_N.+1 & 'I_(darts_at i)}].
Definition dart_at i j : log_dart :=
  Tagged (fun i : 'I_N.+1 => 'I_(darts_at i))
    (Ordinal (ltn_pmod j (ltn0Sn _) : j %% darts_at (inord i : 'I_N.+1) < darts_at (inord i :
      'I_N.+1))).
Implicit Types p q : log_dart.
Definition next_dart p := dart_at (tag p) (val (tagged p)).+1.
Definition crossing i := (dart_at i (motion_at i), dart_at i.+1 0).
Definition crossed p q :=
  has (fun i => ((p, q) == crossing i) || ((q, p) == crossing i)) (iota 0 N).
Definition sensed_pointed p :=
  has (fun i => if (percept_at i).2 is Some b then p == dart_at i b else false) (iota 0 N.+1).

Definition same_dart := same next_dart crossed sensed_pointed.
Definition dart_settled := settled next_dart crossed sensed_pointed.
Definition no_open_dart := forall p, dart_settled p.

Lemma dart_atP p : p = dart_at (tag p) (val (tagged p)).
Proof.
case: p => i j; rewrite /dart_at /= inord_val; congr (Tagged _ _); apply: val_inj => /=.
by rewrite modn_small.
Qed.

Lemma dart_at_eq i j k : i <= N -> j = k %[mod darts_at i] -> dart_at i j = dart_at i k.
Proof.
move=> li E; rewrite /dart_at; congr (Tagged _ _); apply: val_inj => /=.
by rewrite inordK // ltnS.
Qed.

Lemma next_dart_at i j : i <= N -> next_dart (dart_at i j) = dart_at i j.+1.
Proof.
move=> li; rewrite /next_dart /= inordK ?ltnS //; apply: dart_at_eq => //.
by rewrite -addn1 modnDml addn1.
Qed.

Lemma iter_next_dart i j k : i <= N -> iter k next_dart (dart_at i j) = dart_at i (k + j).
Proof. by move=> li; elim: k => //= k ->; exact: next_dart_at. Qed.

Lemma next_dart_inj : injective next_dart.
Proof.
have iterK (p : log_dart) : iter (darts_at (tag p)) next_dart p = p.
  rewrite {2 3}(dart_atP p) iter_next_dart; last by rewrite -ltnS.
  by apply: dart_at_eq; [rewrite -ltnS | rewrite modnDl].
have tagE p : tag (next_dart p) = tag p by rewrite /= inord_val.
move=> p q E; have := iterK p; rewrite -[in tag p](tagE p) E [in tag (next_dart q)]tagE.
by rewrite /darts_at iterSr E -iterSr => <-; exact: iterK.
Qed.

Lemma same_dart_congruence : congruence next_dart crossed sensed_pointed same_dart.
Proof. exact: same_congruence. Qed.



(* ---- What the log says of a world that agrees with it ---- *)
Section Agrees.
Variable W : lighthouse_world.
Hypothesis A : agrees W L.

Definition robot_at i := walk (take i (motions L)) (@start W).
Definition place (p : log_dart) := iter (val (tagged p)) sigma (robot_at (tag p)).

Lemma percept_atE i : i <= N -> percept_at i = percept_of (robot_at i).
Proof.
have nthP w (d : W) o j : j <= size w -> nth o (percepts_along w d) j =
  percept_of (walk (take j w) d).
  by elim: w d j => [|k w IH] d [|j] //= lj; exact: IH.
by move=> li; rewrite /percept_at -A nthP // size_map.
Qed.

Lemma darts_atE i : i <= N -> darts_at i = degree (robot_at i).
Proof. by move=> li; rewrite /darts_at percept_atE //= prednK ?degree_gt0. Qed.

Lemma robot_atS i : i < N -> robot_at i.+1 = motion (motion_at i) (robot_at i).
Proof.
have step w (d : W) j : j < size w -> walk (take j.+1 w) d = motion (nth 0 w j) (walk (take j w) d).
  by elim: w d j => [|k w IH] d [|j] //= lj; [rewrite take0 | exact: IH].
by move=> li; apply: step; rewrite size_map.
Qed.

Lemma place_at i j : i <= N -> place (dart_at i j) = iter j sigma (robot_at i).
Proof. by move=> li; rewrite /place /= inordK ?ltnS // darts_atE // turn_modulo_degree. Qed.

Lemma place_next p : place (next_dart p) = sigma (place p).
Proof.
have li : tag p <= N by rewrite -ltnS.
by rewrite {2}(dart_atP p) /next_dart !place_at.
Qed.

Lemma place_crossed p q : crossed p q -> place q = alpha (place p).
Proof.
case/hasP=> i; rewrite mem_iota /= => li; case/orP=> /eqP[-> ->].
  by rewrite !place_at //= ?robot_atS // ltnW.
by rewrite !place_at //= ?robot_atS ?alphaK // ltnW.
Qed.

Lemma place_pointed p : sensed_pointed p -> place p = pointed.
Proof.
case/hasP=> i; rewrite mem_iota /= ltnS => li; case E: (percept_at i).2 => [b|] // /eqP->.
move: E; rewrite percept_atE //= /bearing; case: ifP => // c [<-]; rewrite place_at //.
exact: iter_findex.
Qed.

Lemma percept_at0 : percept_at 0 = percept_of (@start W).
Proof. by rewrite percept_atE // /robot_at take0. Qed.

Lemma sensed_pointed_first : sensed_pointed (dart_at 0 (odflt 0 (percept_at 0).2)).
Proof.
apply/hasP; exists 0; first by rewrite mem_iota.
by rewrite percept_at0 /percept_of /= bearing_start.
Qed.

Lemma place_congruence :
  congruence next_dart crossed sensed_pointed (fun p q => place p == place q).
Proof.
split=> [p|p q|q p r|p q|p q p' q'|p q].
- by [].
- by rewrite eq_sym.
- by move/eqP->.
- by rewrite !place_next => /eqP->.
- by move/eqP=> E /place_crossed -> /place_crossed ->; rewrite E.
by move/place_pointed-> => /place_pointed->.
Qed.

(* whatever the folding proves holds in the world *)
Theorem folding_sound p q : same_dart p q -> place p = place q.
Proof. by move=> s; apply/eqP; exact: (same_least place_congruence s). Qed.

Theorem folding_sound_ends p q :
  glued next_dart crossed sensed_pointed p q -> place q = alpha (place p).
Proof. by case/gluedP=> p' /folding_sound -> /place_crossed. Qed.

Lemma place_start : place (dart_at 0 0) = start.
Proof. by rewrite place_at // /robot_at take0. Qed.

(* without open dart the log has met every dart of the world *)
Lemma place_onto : no_open_dart -> forall x : W, exists p, place p = x.
Proof.
move=> nopen; apply: (@everywhere W _ start) => [|x [p <-]|x [p <-]].
- by exists (dart_at 0 0); exact: place_start.
- by exists (next_dart p); rewrite place_next.
have /existsP[q oq] := nopen p; exists q; exact: folding_sound_ends.
Qed.
End Agrees.

(* ---- A log without open dart determines the world ---- *)
Lemma percept_place W W' (A : agrees W L) (A' : agrees W' L) p :
  percept_of (place W' p) = percept_of (place W p).
Proof.
have li : tag p <= N by rewrite -ltnS.
rewrite (dart_atP p) !place_at //; move: (val (tagged p)) => j.
have := percept_atE A' li; rewrite (percept_atE A li) => -[D B].
have T (V : lighthouse_world) (x : V) : 
  percept_of (iter j sigma x) = (degree x, omap (fun b =>
    (b + (degree x - j %% degree x)) %% degree x) (bearing x)).
  have c : at_same_vertex x (iter j sigma x) by exact: fconnect_iter.
  rewrite /percept_of /bearing (degree_same c); congr (_, _).
  have -> : at_same_vertex (iter j sigma x) pointed = at_same_vertex x (@pointed V).
    by rewrite /at_same_vertex (same_connect (fconnect_sym sigma_inj) c).
  case: ifP => // cx; congr Some.
  have E : iter ((findex sigma x pointed + (degree x - j %% degree x)) %% degree x) sigma
    (iter j sigma x) = pointed.
    have -> : iter j sigma x = iter (j %% degree x) sigma x by rewrite turn_modulo_degree.
    have dx : degree (iter (j %% degree x) sigma x) = degree x by apply: degree_same;
      exact: fconnect_iter.
    rewrite -{3}dx turn_modulo_degree -iterD -addnA subnK ?(ltnW (ltn_pmod _ (degree_gt0 _))) //.
    by rewrite iterD iter_degree iter_findex.
  by rewrite -[X in findex _ _ X]E findex_iter // -/(degree _) (degree_same c) ltn_pmod ?degree_gt0.
by rewrite !T -D -B.
Qed.

Theorem folding_determines W W' : agrees W L -> agrees W' L -> no_open_dart ->
  exists f : W -> W', [/\ bijective f, forall x, f (sigma x) = sigma (f x),
    forall x, f (alpha x) = alpha (f x), f pointed = pointed &
    forall i, i <= N -> f (robot_at W i) = robot_at W' i].
Proof.
have key (V V' : lighthouse_world) : agrees V L -> agrees V' L -> no_open_dart ->
    forall p q, place V p = place V q -> place V' p = place V' q.
  move=> A A' nopen p q E.
  have bis w (r t : log_dart) : place V r = place V t ->
      exists r' t', [/\ place V r' = walk w (place V r), place V t' = walk w (place V t), 
        place V' r' = walk w (place V' r) & place V' t' = walk w (place V' t)].
    elim: w r t => [|k w IH] r t E'; first by exists r, t.
    have step (u : log_dart) : exists u', place V u' = motion k (place V u) /\ place V' u' =
      motion k (place V' u).
      have tn : exists v, place V v = iter k sigma (place V u) /\ place V' v =
        iter k sigma (place V' u).
        elim: k => [|k [v [e e']]]; first by exists u.
        by exists (next_dart v); rewrite !place_next // e e'.
      have [v [e e']] := tn; have /existsP[u' o] := nopen v; exists u'.
      by rewrite (folding_sound_ends A o) (folding_sound_ends A' o) e e'.
    have [r' [e1 e2]] := step r; have [t' [e3 e4]] := step t.
    have [|r'' [t'' [f1 f2 f3 f4]]] := IH r' t'; first by rewrite e1 e3 E'.
    by exists r'', t''; rewrite f1 f2 f3 f4 e1 e2 e3 e4.
  (* some motions lead from place V p to a dart at v0 *)
  have [w [b B]] : exists w b, bearing (walk w (place V p)) = Some b.
    have: exists w k, walk w (place V p) = iter k sigma start.
      pose R (x : V) := exists w k, walk w (place V p) = iter k sigma x.
      suff H : forall x, R x by exact: H.
      have Rs x : R x -> R (sigma x).
        case=> w [k e]; exists w, (opposite (degree x) 1 + k); rewrite e addnC iterD;
          congr (iter _ _ _).
        by rewrite -[in LHS](opposite_turn 1 x).
      apply: (@everywhere V R (place V p)) => [||x [w [k e]]] //; first by exists [::], 0.
      exists (rcons w (opposite (degree x) k)), 0.
      have -> v d j : walk (rcons v j) d = motion j (walk v d) by elim: v d => //= a v IHv d.
      rewrite e /motion /=; congr alpha; have := opposite_turn k x.
      by [].
    case=> w [k e]; exists w; rewrite e; have c : at_same_vertex (iter k sigma start) (@pointed V).
      rewrite /at_same_vertex -(same_connect (fconnect_sym sigma_inj) (fconnect_iter _ k _)).
      exact: pointed_at_v0.
    by rewrite /bearing c; eexists.
  have [p' [q' [e1 e2 e3 e4]]] := bis w p q E.
  apply: (@walk_inj _ w); rewrite -e3 -e4.
  have P1 := percept_place A A' p'; have P2 := percept_place A A' q'.
  rewrite e1 in P1; rewrite e2 -E in P2; case: P1 => _ B1; case: P2 => _ B2.
  by apply: (@bearing_inj V' _ _ b); rewrite ?B1 ?B2.
move=> A A' nopen.
pose pre (V : lighthouse_world) (x : V) := odflt (dart_at 0 0) [pick p | place V p == x].
have preP V (AV : agrees V L) x : place V (pre V x) = x.
  rewrite /pre; case: pickP => [p /eqP //|H]; have [p e] := place_onto AV nopen x.
  by have := H p; rewrite e eqxx.
pose f (x : W) := place W' (pre W x); pose g (y : W') := place W (pre W' y).
have fP p : f (place W p) = place W' p by apply: (key W W') => //; exact: preP.
have gP p : g (place W' p) = place W p by apply: (key W' W) => //; exact: preP.
exists f; split.
- by exists g => [x|y]; [rewrite [f x]/(place W' _) gP preP | rewrite [g y]/(place W _) fP preP].
- by move=> x; rewrite -{1}(preP W A x) -place_next // fP place_next.
- move=> x; rewrite -{1}(preP W A x); have /existsP[q o] := nopen (pre W x).
  by rewrite -(folding_sound_ends A o) fP (folding_sound_ends A' o).
- have m := sensed_pointed_first A; by rewrite -(place_pointed A m) fP (place_pointed A' m).
by move=> i li; rewrite -[robot_at W i](place_at A 0 li) fP place_at.
Qed.

Corollary folding_isomorphic W W' : agrees W L -> agrees W' L -> no_open_dart ->
  forall i, i <= N -> isomorphic (rooted (@robot_at W i)) (rooted (@robot_at W' i)).
Proof.
move=> A A' nopen i li; have [f [[g fK gK] fs fa _ fr]] := folding_determines A A' nopen.
exists f, g; split=> [x _|y _|] /=; [by split | by split | exact: fr].
Qed.

(* ---- A log with an open dart: two worlds agree with it ---- *)
Section Open.
Variable W : lighthouse_world.
Hypothesis A : agrees W L.
Local Notation folded_log := (folded next_dart crossed sensed_pointed).
Local Notation fold := (@fold log_dart next_dart crossed sensed_pointed).
Local Notation turns := (@folded_next log_dart next_dart crossed sensed_pointed).
Local Notation ends := (@folded_end log_dart next_dart crossed sensed_pointed).

Lemma turns_inj : injective turns.
Proof.
have Cg := same_dart_congruence.
move=> f g; rewrite -(fold_val f) -(fold_val g) !folded_nextE => /eqP; rewrite foldE => s.
have back : forall k x y, same_dart x y -> same_dart (iter k next_dart x) (iter k next_dart y).
  by elim=> //= k IH x y /IH; exact: (congruence_next Cg).
apply/eqP; rewrite foldE.
pose x := val f; pose y := val g; rewrite -/x -/y in s *.
have cyc z : exists2 k, 0 < k & iter k next_dart z = z.
  by exists (order next_dart z); [exact: order_gt0 | exact: (iter_order next_dart_inj)].
have [k k0 Ek] := cyc x; have [l l0 El] := cyc y.
have mult n z j : iter n next_dart z = z -> iter (j * n) next_dart z = z.
  by move=> E; elim: j => // j IH; rewrite mulSn iterD IH.
have := back (k * l).-1 _ _ s; rewrite -!iterSr prednK ?muln_gt0 ?k0 //.
by rewrite (mult l y k) // mulnC (mult k x l).
Qed.

Lemma ends_sym f g : ends f = Some g -> ends g = Some f.
Proof.
move/eqP/folded_endP=> [x [y [E E' l]]]; apply/eqP/folded_endP; exists y, x; split=> //.
case/hasP: l => i li l; apply/hasP; exists i => //; by rewrite orbC.
Qed.

Lemma ends_neq f : ends f <> Some f.
Proof.
move/eqP/folded_endP=> [x [y [E E' l]]]; have := place_crossed A l.
have -> : place W y = place W x by apply: (folding_sound A); rewrite /same_dart -foldE E E'.
by move/esym/eqP; rewrite (negbTE (alpha_neq _)).
Qed.

Lemma folded_connected f g : connect (fun u v => (v == turns u) || (ends u == Some v)) f g.
Proof.
set e := fun u v => _; have sym x y : connect e x y -> connect e y x.
  case/connectP=> p + ->; elim: p x => //= z p IH x /andP[H /IH]; move/connect_trans; apply.
  case/orP: H => /eqP H; last by apply: connect1; rewrite /e (ends_sym H) eqxx orbT.
  have : fconnect turns z x by rewrite H (fconnect_sym turns_inj) fconnect1.
  by apply: connect_sub => a b /eqP <-; apply: connect1; rewrite /e eqxx.
have turn i j : i <= N -> connect e (fold (dart_at i 0)) (fold (dart_at i j)).
  move=> li; elim: j => // j IH; apply: connect_trans IH (connect1 _); apply/orP; left.
  by rewrite folded_nextE next_dart_at.
have start i : i <= N -> connect e (fold (dart_at 0 0)) (fold (dart_at i 0)).
  elim: i => // i IH li; apply: connect_trans (IH (ltnW li)) _.
  apply: connect_trans (turn i (motion_at i) (ltnW li)) (connect1 _); apply/orP; right.
  apply/folded_endP; exists (dart_at i (motion_at i)), (dart_at i.+1 0); split=> //.
  by apply/hasP; exists i; rewrite ?mem_iota // eqxx.
have all h : connect e (fold (dart_at 0 0)) h.
  rewrite -(fold_val h) (dart_atP (val h)); have li : tag (val h) <= N by rewrite -ltnS.
  exact: connect_trans (start _ li) (turn _ _ li).
exact: connect_trans (sym _ _ (all f)) (all g).
Qed.

Section Plug.
Variables (T : finType) (sT aT : T -> T) (stem : T).
Hypotheses (sT_inj : injective sT) (aTK : involutive aT).
Hypothesis aT_stem : forall t, (aT t == t) = (t == stem).
Hypothesis connT : forall t, connect (adjacent sT aT) stem t.

Definition completed_map :=
  completion turns_inj ends_sym ends_neq folded_connected sT_inj aTK aT_stem connT.
Definition old (p : log_dart) : completed_map := inl (fold p).

Lemma old_turn k p : iter k sigma (old p) = old (iter k next_dart p).
Proof. by rewrite /old -folded_iter; elim: k => //= k ->. Qed.

Lemma old_turn_at i k : i <= N -> iter k sigma (old (dart_at i 0)) = old (dart_at i k).
Proof. by move=> li; rewrite old_turn iter_next_dart // addn0. Qed.

Lemma old_crossed p q : crossed p q -> alpha (old p) = old q.
Proof.
move=> c; apply: (completed_alpha_glued (o := ends)); apply/eqP/folded_endP.
by exists p, q.
Qed.

Lemma oldE p q : (old p == old q) = same_dart p q.
Proof. by rewrite /same_dart -foldE. Qed.

Lemma old_pointed : at_same_vertex (old (dart_at 0 0)) (old (dart_at 0 (odflt 0 (percept_at 0).2))).
Proof.
have <- := old_turn_at (odflt 0 (percept_at 0).2) (leq0n N); exact: fconnect_iter.
Qed.

Definition completed_world := LighthouseWorld old_pointed.

Lemma old_robot i : i <= N -> walk (take i (motions L)) (@start completed_world) =
  old (dart_at i 0).
Proof.
elim: i => [|i IH] li; first by rewrite take0.
have := @robot_atS completed_world i li; rewrite /robot_at => ->; rewrite IH ?(ltnW li) //.
rewrite /motion old_turn_at ?(ltnW li) //; apply: old_crossed.
by apply/hasP; exists i; rewrite ?mem_iota // eqxx.
Qed.

Lemma completed_agrees : agrees completed_world L.
Proof.
have nthP (V : lighthouse_world) w (d : V) o j : j <= size w ->
    nth o (percepts_along w d) j = percept_of (walk (take j w) d).
  by elim: w d j => [|k w IH] d [|j] //= lj; exact: IH.
apply: (@eq_from_nth _ (first_percept L)); first by rewrite size_percepts /= !size_map.
move=> i; rewrite size_percepts size_map ltnS => li; rewrite nthP ?size_map // old_robot //.
rewrite -/(percept_at i) (percept_atE A) //; apply: percept_transfer => j.
  rewrite old_turn_at // oldE; apply/idP/eqP=> [/(folding_sound A)|E]; first by rewrite !place_at.
  rewrite (@dart_at_eq i j 0) ?(congruence_refl same_dart_congruence) // (darts_atE A) // mod0n.
  have lt := ltn_pmod j (degree_gt0 (robot_at W i)).
  by rewrite -(findex_iter lt) turn_modulo_degree E findex0.
rewrite old_turn_at // oldE; apply/idP/eqP=> [/(folding_sound A)|E].
  by rewrite (place_pointed A (sensed_pointed_first A)) place_at.
apply: (congruence_mark same_dart_congruence); last exact: (sensed_pointed_first A).
apply/hasP; exists i; first by rewrite mem_iota.
have c : at_same_vertex (robot_at W i) pointed by rewrite -E; exact: fconnect_iter.
rewrite (percept_atE A) // /percept_of /bearing /= c; apply/eqP/dart_at_eq => //.
rewrite (darts_atE A) // -[X in findex _ _ X]E -turn_modulo_degree findex_iter ?modn_mod //.
exact: ltn_pmod (degree_gt0 _).
Qed.

Lemma card_completed_world : #|completed_world| = #|folded_log| + #|loose ends| * #|T|.
Proof. exact: card_completion. Qed.
End Plug.
End Open.
End Log.

(* the two ways in which every open dart is completed: by a vertex of degree 1; by a vertex of
   degree 3 with a loop *)
Lemma leaf_end (t : unit) : (id t == t) = (t == tt).
Proof. by case: t. Qed.

Lemma leaf_connected (t : unit) : connect (adjacent id id) tt t.
Proof. by case: t; exact: connect0. Qed.

Definition loop_sigma (t : option bool) : option bool :=
  match t with None => Some true | Some true => Some false | Some false => None end.
Definition loop_alpha : option bool -> option bool := omap negb.

Lemma loop_sigma_inj : injective loop_sigma.
Proof. by move=> [[]|] [[]|]. Qed.

Lemma loop_alphaK : involutive loop_alpha.
Proof. by move=> [[]|]. Qed.

Lemma loop_end t : (loop_alpha t == t) = (t == None).
Proof. by case: t => [[]|]. Qed.

Lemma loop_connected t : connect (adjacent loop_sigma loop_alpha) None t.
Proof.
case: t => [[]|]; last exact: connect0; first exact: connect1.
by apply: (@connect_trans _ _ (Some true)); exact: connect1.
Qed.

Section TwoWorlds.
Variables (L : log) (W : lighthouse_world).
Hypothesis A : agrees W L.

Definition with_leaves : lighthouse_world :=
  completed_world A (@inj_id unit) (fun t => erefl) leaf_end leaf_connected.

Definition with_loops : lighthouse_world :=
  completed_world A loop_sigma_inj loop_alphaK loop_end loop_connected.

Theorem open_dart_two_worlds (p : log_dart L) : ~~ dart_settled p ->
  [/\ agrees with_leaves L, agrees with_loops L & edges with_leaves <> edges with_loops].
Proof.
move=> np; split; try exact: completed_agrees.
move/(congr1 double); rewrite !edges_double !card_completed_world card_unit card_option card_bool.
move/addnI/eqP; rewrite eqn_mul2l; case/orP=> // /eqP E.
have G : folded_end (fold (@next_dart L) (@crossed L) (@sensed_pointed L) p) == None.
  by rewrite folded_end_none.
suff: 0 < #|loose (@folded_end _ (@next_dart L) (@crossed L) (@sensed_pointed L))| by rewrite E.
by apply/card_gt0P; exists (as_loose G).
Qed.
End TwoWorlds.

Corollary no_open_dart_iff L W : agrees W L ->
  no_open_dart L <->
  (forall W1 W2, agrees W1 L -> agrees W2 L ->
    isomorphic (rooted (@start W1)) (rooted (@start W2))).
Proof.
move=> A; split=> [nopen W1 W2 A1 A2|H p].
  have := folding_isomorphic A1 A2 nopen (leq0n _); by rewrite /robot_at !take0.
have [//|np] := boolP (dart_settled p); have [A1 A2 []] := open_dart_two_worlds A np.
have [f [g [F G _]]] := H _ _ A1 A2.
apply: double_inj; rewrite !edges_double; apply: (@bij_eq_card _ _ f).
by exists g => x; [have [] := F x isT | have [] := G x isT].
Qed.

(* ---- The log of an explorer ---- *)
Definition right_everywhere E (meaning : E -> rooted_map) (X : explorer percept E) :=
  forall W : lighthouse_world, right meaning X (rooted (@start W)) (@percept_of W).

Section RightExplorer.
Variables (E : Type) (meaning : E -> rooted_map) (X : explorer percept E).

Lemma explore_log (W : lighthouse_world) fuel seen (d : W) t e z :
  explore X (rooted (@start W)) (@percept_of W) fuel seen d = (t, e, z) ->
  percepts_along (unzip1 t) d = percept_of d :: unzip2 t /\ z = walk (unzip1 t) d.
Proof.
elim: fuel seen d t e z => [|fuel IH] seen d t e z /=; case: (X seen) => [k|a].
- by case=> <- _ <-.
- by case=> <- _ <-.
- case R: (explore _ _ _ _ _ _) => [[t' e'] z'] [<- _ <-] /=; have [P Q] := IH _ _ _ _ _ R.
  by split=> //; congr (_ :: _).
by case=> <- _ <-.
Qed.

Lemma explore_replay (W W' : lighthouse_world) fuel seen (d : W) (d' : W') t e z :
  explore X (rooted (@start W)) (@percept_of W) fuel seen d = (t, e, z) ->
  percepts_along (unzip1 t) d' = percept_of d' :: unzip2 t ->
  explore X (rooted (@start W')) (@percept_of W') fuel seen d' = (t, e, walk (unzip1 t) d').
Proof.
elim: fuel seen d d' t e z => [|fuel IH] seen d d' t e z /=; case: (X seen) => [k|a].
- by case=> <- <- _.
- by case=> <- <- _.
- case R: (explore _ _ _ _ _ _) => [[t' e'] z'] [<- <- _] /= [P].
  have ph : percept_of (motion k d') = percept_of (motion k d).
    by have := congr1 (head (0, None)) P; case: (unzip1 t').
  have Q : explore X (rooted (@start W')) (@percept_of W') fuel
      (rcons seen (percept_of (motion k d'))) (motion k d') =
        (t', e', walk (unzip1 t') (motion k d')).
    by rewrite ph; apply: (IH _ _ _ _ _ _ R); rewrite P ph.
  by rewrite Q; congr ((k, _) :: _, _, _); exact: ph.
by case=> <- <- _.
Qed.

Definition log_of (W : lighthouse_world) t := Log (percept_of (@start W)) t.

Lemma episode_agrees (W : lighthouse_world) fuel t e z :
  episode X (rooted (@start W)) (@percept_of W) fuel = (t, e, z) -> agrees W (log_of W t).
Proof. by case/explore_log. Qed.

(* an explorer that is right in two worlds that agree with its log: they are the same rooted map *)
Theorem right_explorer_determines (W W' : lighthouse_world) fuel t e z :
  right meaning X (rooted (@start W)) (@percept_of W) ->
  right meaning X (rooted (@start W')) (@percept_of W') ->
  episode X (rooted (@start W)) (@percept_of W) fuel = (t, Some e, z) ->
  agrees W' (log_of W t) -> isomorphic (rooted (@start W)) (rooted (@start W')).
Proof.
move=> [f1 [t1 [e1 [z1 [R1 We1 I1]]]]] [f2 [t2 [e2 [z2 [R2 We2 I2]]]]] R A'.
have zE := (explore_log R).2.
have P : percept_of (@start W') = percept_of (@start W) 
  by have := congr1 (head (0, None)) A'; case: (t).
have R' : episode X (rooted (@start W')) (@percept_of W') fuel =
  (t, Some e, walk (unzip1 t) (@start W')).
  have R0 : explore X (rooted (@start W)) (@percept_of W) fuel [:: percept_of (@start W)] (@start W)
    = (t, Some e, z) by [].
  by have := explore_replay R0 (etrans A' (f_equal (cons^~ _) (esym P))); rewrite -P.
have := explore_more fuel R1; rewrite addnC (explore_more f1 R) => -[_ ee zz]; subst e1 z1.
have := explore_more fuel R2; rewrite addnC (explore_more f2 R') => -[_ ee zz]; subst e2 z2.
have I := isomorphic_trans (isomorphic_sym We1 I1) I2; rewrite zE in I.
have walkE (V : lighthouse_world) v (d : V) : walk_in (rooted (@start V)) v d =
  walk v d by elim: v d => /=.
apply: (@isomorphic_back (rooted (@start W)) (rooted (@start W')) (unzip1 t) start start) => //.
- exact: rooted_wellformed.
- exact: rooted_wellformed.
by rewrite !walkE.
Qed.

Theorem right_explorer_log_folds : right_everywhere meaning X ->
  forall W fuel t e z,
  episode X (rooted (@start W)) (@percept_of W) fuel = (t, Some e, z) -> no_open_dart (log_of W t).
Proof.
move=> H W fuel t e z R; have A := episode_agrees R; apply/(no_open_dart_iff A) => W1 W2 A1 A2.
apply: isomorphic_trans (right_explorer_determines (H W) (H W2) R A2).
apply: isomorphic_sym; first exact: rooted_wellformed.
exact: right_explorer_determines (H W) (H W1) R A1.
Qed.
End RightExplorer.
