% READINGSOF  Which targets one rule reads off.
%
% CALL: READINGS = readingsOf (INFO, GIVEN)
%
%   INFO      1 x T struct of targetInfo: kind, unit
%   GIVEN     struct of newProblem: curve, bench, benchNames, seriesNames
%   READINGS  1 x T cellstr: each curve, else the kind (length, angle, time ...),
%             else the unit, else ''

function readings = readingsOf (info, given)
  readings = {info.unit};
  for t = 1:numel (info)
    text = regexprep (info(t).kind, {'^(angleFalling|coneAngle)$', ...
                                     '^(offset|height|level)$'}, ...
                      {'angle', 'length'});
    if given.curve(t) > 0
      text = sprintf ('%s %s', given.benchNames{given.bench(t)}, ...
                      given.seriesNames{t});
    end
    if ~isempty (text)
      readings{t} = text;
    end
  end
end

%!test
%! info = struct ('kind', {'coneAngle', 'level', '', '', 'height'}, ...
%!                'unit', {'deg', 'm', 'g', '', 'm'});
%! given = struct ('curve', [0, 0, 0, 0, 1], 'bench', [1, 1, 1, 1, 2], ...
%!                 'benchNames', {{'A', 'B'}}, 'seriesNames', ...
%!                 {{'', '', '', '', 'profile'}});
%! assert (readingsOf (info, given), ...
%!         {'angle', 'length', 'g', '', 'B profile'});

% SPDX-License-Identifier: GPL-3.0-only
