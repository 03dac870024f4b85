% CHANGEDINPUT  Parts of the input that have changed since a result was made.
%
% CALL: PARTS = changedInput (RESULT, CASE, NOW)
%
%   RESULT  decoded results/calibration.json or gap/gap.json, or []
%   NOW     see resultInput, of the case as it is
%   PARTS   1 x n cell of words, such as 'targets'; none where RESULT is of
%           today's input, or does not say of which
%
% The LIGGGHTS build counts where there is one now (a page may be looked at on a
% machine without), conditions and effects in a diagnosis, effects where they are
% loaded (a calibration does not).

function parts = changedInput (result, now)
  words = {'targets', 'targets'; 'limits', 'parameters or limits'; ...
           'model', 'model'; 'LIGGGHTS', 'LIGGGHTS'; ...
           'levels', 'Input.coarse'; 'costFunction', 'costFunction.m'; ...
           'runsTable', 'runs.csv'; 'settings', 'settings'; ...
           'effects', 'effects'; 'conditions', 'conditions'};
  parts = cell (1, 0);
  was = jsonAt (result, {'input', 'digest'});
  if isempty (was)
    return
  end
  isAsked = isSameModel (result, now);
  now = now.digest;
  for name = {'LIGGGHTS', 'effects'}
    if isempty (strtrim (now.(name{1})))
      now.(name{1}) = givenField (was, name{1}, '');
    end
  end
  if ~isfield (result, 'which')
    words(end - 1:end, :) = [];
  end
  % before and behind a mark, as an empty text has many shapes
  as = @(text) ['<', text, '>'];
  isSame = cellfun (@(name) strcmp (as (givenField (was, name, '')), ...
                                    as (now.(name))), words(:, 1));
  % other results are asked of the same model
  isSame(3) = isSame(3) || (~isSame(1) && isAsked);
  parts = words(~isSame, 2)';
end

function yes = isSameModel (result, now)
  now = struct ('input', now);
  keys = @(of) eachOf (@(m) [m.name, ' ', m.key], jsonList (of, {'input', 'models'}));
  vars = @(of) jsonencode (jsonAt (of, {'input', 'modelVars'}));
  yes = isequal (keys (result), keys (now)) && strcmp (vars (result), vars (now));
end

%!test
%! Case = readyCase ();
%! now = resultInput (Case);
%! now.digest.effects = 'e';
%! was = jsondecode (jsonencode (struct ('input', now)));
%! assert (changedInput (was, now), cell (1, 0));
%! assert (changedInput ([], now), cell (1, 0));
%! assert (changedInput (struct ('reason', 'x'), now), cell (1, 0));
%! was.input.digest.targets = 'x';
%! was.input.digest.effects = 'x';
%! assert (changedInput (was, now), {'targets'});
%! was.which = 1;
%! assert (changedInput (was, now), {'targets', 'effects'});
%! % a line less in measured.csv asks the same model for other results
%! was.input.digest.model = 'x';
%! assert (changedInput (was, now), {'targets', 'effects'});
%! was.input.models(1).key = 'x';
%! assert (changedInput (was, now), {'targets', 'model', 'effects'});
%! was.input.digest.model = now.digest.model;
%! % a condition that was measured later makes no calibration old
%! was.input.digest.conditions = 'x';
%! assert (changedInput (was, now), {'targets', 'effects', 'conditions'});
%! assert (changedInput (rmfield (was, 'which'), now), {'targets'});
%! was.input.digest.conditions = now.digest.conditions;
%! % on a machine without LIGGGHTS that part is not known
%! was.input.digest.LIGGGHTS = 'build';
%! now.digest.LIGGGHTS = '';
%! assert (changedInput (was, now), {'targets', 'effects'});
%! now.digest.LIGGGHTS = 'other';
%! assert (changedInput (was, now), {'targets', 'LIGGGHTS', 'effects'});

% SPDX-License-Identifier: GPL-3.0-only
