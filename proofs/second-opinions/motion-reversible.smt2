; One motion is reversible
; Says: Motion k leaves by sigma^k of the dart the robot stands at and arrives in the other end.
;   Motion 0 then crosses the same edge back, and turning by -k restores the orientation.
; Paper: IV, Algorithm 1, line 14 (the robot retraces, resuming its original orientation)
; Symbols:
;   Dart         the darts of the world G
;   alpha        the other end of the same edge
;   turn, back   sigma^k for a fixed k, and its inverse (turns-reversible)
;   move         motion k
;   d            the dart where the claim fails
; Expected: unsat

(set-logic UF)
(declare-sort Dart 0)
(declare-fun alpha (Dart) Dart)
(declare-fun turn (Dart) Dart)
(declare-fun back (Dart) Dart)
(declare-fun move (Dart) Dart)
(declare-const d Dart)

; an edge has two ends
(assert (forall ((x Dart)) (= (alpha (alpha x)) x)))
; turning is reversible
(assert (forall ((x Dart)) (= (back (turn x)) x)))
; motion k
(assert (forall ((x Dart)) (= (move x) (alpha (turn x)))))

; not: motion 0 comes back to the dart left by, and the turn by -k to the dart stood at
(assert (not (and (= (alpha (move d)) (turn d)) (= (back (alpha (move d))) d))))
(check-sat)
