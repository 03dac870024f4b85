% TARGETINFO  What each target of a case is.
%
% CALL: INFO = targetInfo (CASE)
%
%   CASE  see newCase
%   INFO  1 x T struct array as of resultInfo: name, kind, unit, series, at,
%         text; '' and NaN where nobody says it
%
% From results.csv of the model: the row of the result with that number or, of a
% case with measured.csv, with that name, else of its series, or with the name of
% its series, with the settings that the case runs (resultInfo). What measured.csv
% says of unit, series and at goes before it.

function info = targetInfo (Case)
  blank = struct ('name', '', 'kind', '', 'unit', '', 'series', '', ...
                  'at', NaN, 'text', '');
  info = repmat (blank, 1, numel (Case.targets));
  for k = 1:numel (Case.models)
    folder = Case.models(k).folder;
    ofModel = resultInfo (folder, givenField (Case, 'modelVars', struct ()));
    for t = find ([Case.targets.model] == k)
      info(t) = oneInfo (Case.targets(t), ofModel, blank);
    end
  end
end

function info = oneInfo (T, ofModel, info)
  if ~isfield (T, 'result') || isempty (T.result)
    if numel (ofModel) >= T.index
      info = ofModel(T.index);
    end
    return
  end
  if ~isempty (ofModel)
    row = [find(strcmp ({ofModel.name}, T.result)), ...
           find(strcmp ({ofModel.series}, T.series) & ~isempty (T.series)), ...
           find(strcmp ({ofModel.name}, T.series))];
    if ~isempty (row)
      info = ofModel(row(1));
    end
  end
  info.name = T.name;
  if ~isempty (T.unit)
    info.unit = T.unit;
  end
  if ~isempty (T.series)
    info.series = T.series;
    info.at = T.at;
  end
end

%!test
%! folder = emptyFolder ();
%! writeAtomic (fullfile (folder, 'results.csv'), ...
%!              ["name,kind,unit,series,at,text\nr,rate,kg/s,q,2,x\n", ...
%!               "w,mass,kg,,,x\nm,mass,kg,,,x\n"]);
%! Case.models = struct ('name', 'A', 'folder', folder);
%! Case.targets = struct ('model', 1, 'index', {1, 2, 3, 4}, ...
%!                        'name', {'w@1', 'w@2', 'r', 'z'}, ...
%!                        'result', {'w', 'w at 2', 'r', 'z'}, ...
%!                        'series', {'w', 'w', '', ''}, ...
%!                        'at', {1, 2, NaN, NaN}, ...
%!                        'unit', {'', 'g', '', 'm'});
%! info = targetInfo (Case);
%! Case.targets = rmfield (Case.targets, 'result');
%! byNumber = targetInfo (Case);
%! delete (fullfile (folder, 'results.csv'));
%! rmdir (folder);
%! assert ({info.kind}, {'mass', 'mass', 'rate', ''});
%! assert ({info.unit}, {'kg', 'g', 'kg/s', 'm'});
%! assert ({info.series}, {'w', 'w', 'q', ''});
%! assert ([info.at], [1, 2, 2, NaN]);
%! assert ({byNumber.name}, {'r', 'w', 'm', ''});

% SPDX-License-Identifier: GPL-3.0-only
