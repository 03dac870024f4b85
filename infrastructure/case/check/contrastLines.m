% CONTRASTLINES  Marks what is a contrast within a session.
%
% CALL: LINES = contrastLines (LINES, MODELS)
%
%   LINES   1 x n struct of readMeasured
%   MODELS  1 x M struct, see checkFindModels
%   LINES   the same with isContrast (logical): results.csv has the kind ratio,
%           logRatio or difference, of two settings of one session, from which
%           most of what a session changes drops out
%
% See also: varianceComponents

function lines = contrastLines (lines, models)
  [lines.isContrast] = deal (false);
  for k = 1:numel (models)
    info = checkResultInfo (models(k).folder);
    isIt = ismember ({info.kind}, {'ratio', 'logRatio', 'difference'});
    names = setdiff ([{info(isIt).name}, {info(isIt).series}], {''});
    for j = find ([lines.model] == k)
      lines(j).isContrast = any (ismember ({lines(j).name, lines(j).series}, ...
                                           names));
    end
  end
end

%!test
%! folder = emptyFolder ();
%! writeAtomic (fullfile (folder, 'results.csv'), ...
%!              ["name,kind,unit,series,at,text\na,logRatio,-,,,x\n", ...
%!               "b,mass,kg,,,x\nc,ratio,-,w,3,x\n"]);
%! lines = struct ('name', {'a', 'b', '', 'a'}, 'series', {'', '', 'w', ''}, ...
%!                 'model', {1, 1, 1, 0});
%! lines = contrastLines (lines, struct ('folder', folder));
%! assert ([lines.isContrast], [true, false, true, false]);

% SPDX-License-Identifier: GPL-3.0-only
