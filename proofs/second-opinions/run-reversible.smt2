; A run of motions is reversible: induction step over its length
; Says: If the run w can be undone, so can the run k w: undo w, cross back, turn by -k. Hence a
;   rejected hypothesis leaves the robot where it was, oriented as it was.
; Paper: IV, Algorithm 1, line 14; text after case (3)
; Symbols:
;   Dart             the darts of the world G
;   alpha            the other end of the same edge
;   turn, back       sigma^k for a fixed k, and its inverse (turns-reversible)
;   run_w, undo_w    where the motions w lead; their reversal.  run_kw, undo_kw: for k followed by w
;   d                the dart where the claim fails
; Expected: unsat

(set-logic UF)
(declare-sort Dart 0)
(declare-fun alpha (Dart) Dart)
(declare-fun turn (Dart) Dart)
(declare-fun back (Dart) Dart)
(declare-fun run_w (Dart) Dart)
(declare-fun undo_w (Dart) Dart)
(declare-fun run_kw (Dart) Dart)
(declare-fun undo_kw (Dart) Dart)
(declare-const d Dart)

; an edge has two ends
(assert (forall ((x Dart)) (= (alpha (alpha x)) x)))
; turning is reversible
(assert (forall ((x Dart)) (= (back (turn x)) x)))
; first motion k, then w
(assert (forall ((x Dart)) (= (run_kw x) (run_w (alpha (turn x))))))
; w undone, then motion k undone
(assert (forall ((y Dart)) (= (undo_kw y) (back (alpha (undo_w y))))))
; induction hypothesis
(assert (forall ((x Dart)) (= (undo_w (run_w x)) x)))

; not: k followed by w is undone
(assert (not (= (undo_kw (run_kw d)) d)))
(check-sat)
