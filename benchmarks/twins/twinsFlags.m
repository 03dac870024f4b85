% TWINSFLAGS  Says of each twin what came of it: rows of hits and of cases.
%
% CALL: S = twinsFlags (TWINS, VERDICTS)
%
%   TWINS, VERDICTS  of twinsDraw, twinsDiagnose
%   S  struct of 1 x n logicals (numbers where said)
%     null, single, pair, out (not on the list), off, look   classes
%     d, cosine, lab   numbers; dLeast: of the weakest cause alone
%     named, grouped, noGap, unlisted, abstained (a gap, but no name), caveat
%              (named, or something that looks like it)   verdicts
%     gate     the test for a gap fires at 0.05
%     top      the likeliest effect is a true one
%     right    names only true effects, or a group with a true one in it
%     clean    names or groups nothing but true effects
%     both     both of a pair are named
%     covered  the 90 % interval of the strength holds it (singles)
%     odds     posterior odds of the true one, or of something that resembles
%              it, above 20 to 1 (singles)
%
% See also: twinsScore, foreignLines

function s = twinsFlags (twins, verdicts)
  class = {twins.class};
  s.null = strcmp (class, 'null');
  s.single = strcmp (class, 'single');
  s.pair = strcmp (class, 'pair');
  s.off = strcmp (class, 'off') | [twins.removed] > 0;
  s.look = strcmp (class, 'look');
  s.out = strcmp (class, 'out') | s.off | s.look;
  s.lab = [twins.lab];
  s.d = [twins.d];
  s.cosine = [twins.cosine];
  kind = {verdicts.kind};
  s.named = strcmp (kind, 'named');
  s.grouped = strcmp (kind, 'group');
  s.noGap = strcmp (kind, 'no gap');
  s.unlisted = strcmp (kind, 'none of the listed');
  s.abstained = ~(s.named | s.grouped | s.noGap);
  s.caveat = s.named & [verdicts.lookAlike];
  s.gate = [verdicts.gateP] < 0.05;
  for i = 1:numel (twins)
    s.dLeast(i) = min ([twins(i).dEach, Inf]);
    s = oneFlag (s, i, twins(i), verdicts(i));
    [s.covered(i), s.odds(i)] = strengthFlags (s.single(i), twins(i), ...
                                               verdicts(i));
  end
end

function s = oneFlag (s, i, twin, verdict)
  cause = twin.cause(twin.cause > 0);
  said = verdict.effects;
  s.top(i) = ~s.out(i) && any (verdict.top == cause);
  hit = ~(s.out(i) || isempty (said) || isempty (cause));
  isTrue = ismember (said, cause);
  s.right(i) = hit && ((s.named(i) && all (isTrue)) || ...
                       (s.grouped(i) && any (isTrue)));
  s.clean(i) = s.right(i) && all (isTrue);
  s.both(i) = s.right(i) && s.named(i) && numel (said) == 2;
end

function [isCovered, isLikely] = strengthFlags (isSingle, twin, verdict)
  isCovered = false;
  isLikely = false;
  if isSingle
    q = verdict.interval(twin.cause, :);
    phi = twin.phi(twin.cause);
    isCovered = q(2) <= phi && phi <= q(3);
    p = verdict.total(twin.cause);
    isLikely = p > 20 * (1 - p);
  end
end

%!shared twin, verdict
%! twin = struct ('class', 'single', 'cause', 2, 'removed', 0, 'lab', 1, ...
%!                'd', 5, 'cosine', NaN, 'dEach', 5, 'phi', [0, 0.4, 0]);
%! verdict = struct ('kind', 'named', 'effects', 2, 'top', 2, 'P', ...
%!                   [0.01, 0, 0.96, 0, 0.02, 0.01], 'total', [0, 0.96, 0], ...
%!                   'interval', ...
%!                   [0, 0, 0; 0.4, 0.3, 0.5; 0, 0, 0], 'gateP', 0.01, ...
%!                   'lookAlike', false);
%!test % named rightly, with odds of 24 to 1
%! s = twinsFlags (twin, verdict);
%! assert ([s.top, s.right, s.clean, s.covered, s.odds, s.gate] == 1);
%! assert (~(s.both || s.abstained || s.caveat || s.out));
%!test % the wrong one, by a hair
%! verdict.effects = 3;
%! verdict.interval(2, 3) = 0.39;
%! verdict.total(2) = 0.95;
%! s = twinsFlags (twin, verdict);
%! assert (~(s.right || s.clean || s.covered || s.odds) && s.top);
%!test % a group with others is right, not clean; of a pair half is clean
%! verdict.kind = 'group';
%! verdict.effects = [2, 3];
%! s = twinsFlags (twin, verdict);
%! assert (s.right && ~s.clean && s.grouped);
%! twin.class = 'pair';
%! twin.cause = [1, 2];
%! twin.dEach = [4.5, 6];
%! verdict.kind = 'named';
%! verdict.effects = 1;
%! s = twinsFlags (twin, verdict);
%! assert (s.right && s.clean && ~s.both);
%! assert (s.dLeast, 4.5);
%!test % a name for what is not on the list is never right
%! twin.class = 'look';
%! twin.cause = 0;
%! twin.dEach = [];
%! verdict.lookAlike = true;
%! s = twinsFlags (twin, verdict);
%! assert (s.out && s.look && s.named && s.caveat);
%! assert (~(s.right || s.top || s.clean));
