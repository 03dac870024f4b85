% DECIDESTORED  The verdict on what stands in the files of a case.
%
% CALL: V = decideStored (S [, ISBEGUN])
%
%   S        see storedResult
%   ISBEGUN  see decideCase
%   V        see decideCase. Of an earlier input (targets, limits, model ...
%            have changed) it says so first, and what it was; the set is not
%            called usable. A diagnosis of an earlier input beside a calibration
%            of today's is left out, and that is said

function v = decideStored (s, isBegun)
  if nargin < 2
    isBegun = false;
  end
  if isempty (s.changed) && ~isempty (s.gapChanged)
    v = decideCase (s.calibration, [], isBegun);
    v.gap = sentence ('case.earlierGap', struct ('parts', {s.gapChanged}));
    return
  end
  v = decideCase (s.calibration, s.gap, isBegun);
  if ~isempty (s.changed)
    values = struct ('parts', {s.changed}, 'word', v.word, ...
                     'sentence', v.sentence);
    v.sentence = sentence ('case.earlier.sentence', values);
    v.word = sentence ('case.earlier.word', values);
    [v.class, v.usable] = deal ('open', false);
    v.usableFor = {};
    v = withAction (v, newAction (merge (isempty (s.calibration), 'againGap', 'again')));
  end
end

%!test
%! c = verdictCase ()(1).c;
%! s = struct ('calibration', c, 'gap', [], 'changed', {cell(1, 0)}, ...
%!             'gapChanged', {cell(1, 0)});
%! v = decideStored (s);
%! assert (v, decideCase (c, [], false));
%! s.changed = {'targets', 'model'};
%! old = decideStored (s);
%! assert (old.word, 'Result of an earlier input (targets, model changed)');
%! assert (isempty (strfind (old.sentence, 'decalioc')));    % action says what to do
%! assert (~isempty (strfind (old.action, 'decalioc run')));
%! assert (~isempty (strfind (old.sentence, v.word)));
%! assert ({old.usable, old.class}, {false, 'open'});

% SPDX-License-Identifier: GPL-3.0-only
