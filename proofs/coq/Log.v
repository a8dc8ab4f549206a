(* ---------------------------------------------------------------------------------------------
   The log of a robot with a directional lighthouse, and what it says.             Sections IV, V

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
     same_dart            the least congruence of Congruence.v.
     dart_settled p       the folding knows the other end of p.  Otherwise p is open.
     no_open_dart L       all darts of the log are settled.
     robot_at L W i       the robot's dart in W after motion i.
     place W p            the dart of W that p is, when W agrees with the log.
     log_of W t           the log of an episode in W with transcript t.

     folding_sound        what the folding proves holds in every world that agrees with the log:
     folding_sound_ends   the same darts are one dart, and glued darts are the two ends of an edge.
     episode_agrees       the world in which the log was made agrees with it;
     explore_replay       in every world that agrees with it the explorer does the same.
   --------------------------------------------------------------------------------------------- *)
From mathcomp Require Import all_ssreflect.
From Allworlds Require Import Model Maps Percepts RootedMaps Explorers Congruence.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

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

End Log.

(* ---- The log of an explorer ---- *)
Definition log_of (W : lighthouse_world) t := Log (percept_of (@start W)) t.

Section Explorer.
Variables (E : Type) (X : explorer percept E).

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

Lemma episode_agrees (W : lighthouse_world) fuel t e z :
  episode X (rooted (@start W)) (@percept_of W) fuel = (t, e, z) -> agrees W (log_of W t).
Proof. by case/explore_log. Qed.

End Explorer.

