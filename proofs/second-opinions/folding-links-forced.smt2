; Folding: every link is forced, one step
; Says: When a dart of which the other end is known is merged with one of which it is not, the
;   second gets the other end of the first; the other end of that is the second. Links that are
;   true in every world that agrees with the log lead to links that are.
; Paper: V, step 2 (the embedded path is unique), applied to the log of an explorer
; Symbols:
;   Dart           the darts of a world that agrees with the log
;   LogDart        the darts of the tree of places that the log tells of
;   place          the dart of the world that a dart of the log is
;   alpha          the other end of the same edge, in the world
;   merged         the merges so far, forced (folding-merges-forced)
;   linked0        (linked0 x y): y is the other end of x, so far.  linked1: those and the next ones
;   f, g           two darts linked where the claim fails
; Expected: unsat

(set-logic UF)
(declare-sort Dart 0)
(declare-sort LogDart 0)
(declare-fun alpha (Dart) Dart)
(declare-fun place (LogDart) Dart)
(declare-fun merged (LogDart LogDart) Bool)
(declare-fun linked0 (LogDart LogDart) Bool)
(declare-fun linked1 (LogDart LogDart) Bool)
(declare-const f LogDart)
(declare-const g LogDart)

; an edge has two ends
(assert (forall ((d Dart)) (= (alpha (alpha d)) d)))
; merges are forced
(assert (forall ((x LogDart) (y LogDart)) (=> (merged x y) (= (place x) (place y)))))
; one step of linking
(assert (forall ((x LogDart) (y LogDart))
  (= (linked1 x y)
     (or (linked0 x y) (linked0 y x) (exists ((z LogDart)) (and (merged z x) (linked0 z y)))))))
; induction hypothesis
(assert (forall ((x LogDart) (y LogDart)) (=> (linked0 x y) (= (place y) (alpha (place x))))))
; two darts linked
(assert (linked1 f g))

; not: the two ends of an edge of the world
(assert (not (= (place g) (alpha (place f)))))
(check-sat)
