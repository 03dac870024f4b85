% PARAMLABELS  What each calibrated parameter is, in words.
%
% CALL: [LABELS, UNITS] = paramLabels (CASE)
%
%   CASE    see newCase
%   LABELS  d x 1 cell, '' where nobody says it;  UNITS  d x 1 cell, '' none
%
% From the remark behind the variable in data.head of a model (unit, words), else
% from the names that the models of the toolbox use.

function [labels, units] = paramLabels (Case)
  [labels, units] = cellfun (@usualWords, Case.names(:), 'UniformOutput', false);
  folders = {Case.models.folder};
  heads = cellfun (@checkHead, folders(~cellfun (@isempty, folders)), ...
                   'UniformOutput', false);
  for head = fliplr ([heads{:}])
    words = regexp (head.remark, '^([^,]*),[ \t]*(.+)$', 'tokens', 'once');
    j = strcmp (Case.names, head.name);
    if ~isempty (words) && any (j)
      [labels{j}, units{j}] = deal (strtrim (words{2}), strtrim (words{1}));
    end
  end
end

function [text, unit] = usualWords (name)
  known = struct ('density', {{'density of %s', 'kg/m3'}}, ...
                  'radius', {{'radius of %s', 'm'}}, ...
                  'youngsModulus', {{'Young''s modulus of %s', 'Pa'}}, ...
                  'poissonsRatio', {{'Poisson''s ratio of %s', ''}}, ...
                  'coefRestitution', {{'restitution %s', ''}}, ...
                  'coefRollingFriction', {{'rolling friction %s', ''}}, ...
                  'coefFriction', {{'friction %s', ''}}, ...
                  'cohesion', {{'cohesion energy density %s', 'J/m3'}});
  ends = struct ('PP', 'between grains', 'PW', 'of grains and walls', ...
                 'P', 'the grains', 'W', 'the walls');
  [text, unit] = deal ('');
  parts = regexp (name, '^(\w+?)(PP|PW|P|W)$', 'tokens', 'once');
  if ~isempty (parts) && isfield (known, parts{1})
    [form, unit] = known.(parts{1}){:};
    text = sprintf (form, ends.(parts{2}));
  end
end

%!test
%! folder = emptyFolder ();
%! writeAtomic (fullfile (folder, 'data.head'), ...
%!              ["variable lid equal 2 # kg, mass of the lid\n", ...
%!               "variable radiusP equal 1  # m\nvariable a equal 1\n"]);
%! Case = struct ('names', {{'lid', 'radiusP', 'a'}}, ...
%!                'models', struct ('folder', folder));
%! [labels, units] = paramLabels (Case);
%! assert (labels, {'mass of the lid'; 'radius of the grains'; ''});
%! assert (units, {'kg'; 'm'; ''});

% SPDX-License-Identifier: GPL-3.0-only
