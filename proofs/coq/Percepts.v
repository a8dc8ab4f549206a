(* ---------------------------------------------------------------------------------------------
   Percepts, and worlds with a directional lighthouse.                       Sections II.C and IV

     percept                  what is sensed at a vertex: its degree and, where the directional
                              marker lies, its bearing: how many darts clockwise from the dart by
                              which the robot came in the pointed dart is.  No bearing: no marker
                              here.  This is the paper's signature: degree, presence and direction
                              of the marker.
     lighthouse_world         a map, the dart `start` that the robot faces at the start, and the
                              dart `pointed` to which the marker points; both are darts of one
                              vertex, the paper's v0.  Any map, any start dart, any bearing.
     percept_of W d           what the robot senses in W when it has come in by d.
     percepts_along w d       what it senses on the way of the motions w from d, the first percept
                              (before any motion) included.
     first_bearing W          the bearing sensed at the start.
   --------------------------------------------------------------------------------------------- *)
From mathcomp Require Import all_ssreflect.
From Allworlds Require Import Maps.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Definition percept := (nat * option nat)%type.

Record lighthouse_world := LighthouseWorld {
  map_of :> combinatorial_map;
  start : map_of;
  pointed : map_of;
  pointed_at_v0 : at_same_vertex start pointed }.

Arguments start {l}.
Arguments pointed {l}.

Section Percepts.
Variable W : lighthouse_world.
Implicit Types (d x y : W) (w : seq nat).

Definition bearing d :=
  if at_same_vertex d pointed then Some (findex sigma d pointed) else None.
Definition percept_of d : percept := (degree d, bearing d).
Fixpoint percepts_along w d : seq percept :=
  percept_of d :: (if w is k :: w' then percepts_along w' (motion k d) else [::]).
Definition first_bearing := findex sigma start (@pointed W).

Lemma percepts_last w d o : last o (percepts_along w d) = percept_of (walk w d).
Proof. by elim: w d o => //= k w IH d o; rewrite IH. Qed.

Lemma size_percepts w d : size (percepts_along w d) = (size w).+1.
Proof. by elim: w d => //= k w IH d; rewrite IH. Qed.

(* absolute orientation at v0: there the bearing tells by which dart the robot came in *)
Lemma bearing_inj x y j : bearing x = Some j -> bearing y = Some j -> x = y.
Proof.
rewrite /bearing; case: ifP => // cx [jx]; case: ifP => // cy [jy].
by apply: (@iter_sigma_inj _ j); rewrite -{1}jx -jy !iter_findex.
Qed.

Lemma bearing_start : bearing start = Some first_bearing.
Proof. by rewrite /bearing pointed_at_v0. Qed.
End Percepts.

Arguments first_bearing W : clear implicits.
