% SCRIPTPHYSICS  What a LIGGGHTS script says that its grains do not feel.
%
% CALL: [NOTES, CODES] = scriptPhysics (TEXT [, COMMANDS])
%
%   TEXT   of the script, and those that it includes or jumps to
%   COMMANDS  of TEXT, see scriptCommands
%   NOTES  1 x k cell of sentences without their last point
%   CODES  1 x k cell: lost (grains that leave the box vanish, and the script does not
%          count them), inert (a coefficient
%          of two types of grains and walls that no contact model between them reads)
%
% Friction, rolling friction and cohesion of a pair are read by the model of
% pair_style between grains, and by that of fix wall/gran between a grain and a wall:
% a keyword that stands in one of them says nothing of the other. What is 0 in the
% script need not be read.

function [notes, codes] = scriptPhysics (text, commands)
  [notes, codes] = deal (cell (1, 0));
  if nargin < 2
    commands = scriptCommands (text);
  end
  commands = withTexts ({commands.words});
  modes = commands(cellfun (@(w) strcmp (w{1}, 'thermo_modify'), commands));
  modes = [modes{:}, {''}];
  lost = modes([false, strcmp(modes(1:end - 1), 'lost')]);
  counts = ~isempty (regexp (text, 'equal[^\n]*\<count\s*\(', 'once'));
  if ~isempty (lost) && any (strcmp (lost{end}, {'ignore', 'warn'})) && ~counts
    notes{end + 1} = sprintf (['the script says thermo_modify lost %s: grains that leave ' ...
                               'the box vanish, and the run goes on without them. ' ...
                               'Write lost error, unless they are meant to'], lost{end});
    codes{end + 1} = 'lost';
  end
  kinds = {'coefficientFriction', 'tangential', 'friction'; ...
           'coefficientRollingFriction', 'rolling_friction', 'rolling friction'; ...
           'cohesionEnergyDensity', 'cohesion', 'cohesion'};
  for kind = kinds'
    for pair = inertPairs (commands, kind{1:2})
      notes{end + 1} = sprintf (['the %s of types %s is set (%s), but no contact model ' ...
                                 'between them uses it: %s without %s'], kind{3}, ...
                                pair{1}{1}, kind{1}, pair{1}{2}, kind{2});
      codes{end + 1} = 'inert';
    end
  end
  for unread = unreadProperties (commands)
    notes{end + 1} = sprintf (['%s is set, but no contact model of the script reads it ' ...
                               '(%s does)'], unread{1}{:});
    codes{end + 1} = 'inert';
  end
end

% Texts that a variable holds, in its place ("model hertz tangential history"); numbers
% stay with their names, those of the case may take their place.
function commands = withTexts (commands)
  isText = @(w) numel (w) > 3 && strcmp (w{1}, 'variable') && ...
                any (strcmp (w{3}, {'string', 'index'})) && isnan (str2double (w{4}));
  commands = withTypes (commands);
  texts = commands(cellfun (isText, commands));
  names = cellfun (@(w) ['${', w{2}, '}'], texts, 'UniformOutput', false);
  for t = texts
    w = t{1};
    name = ['${', w{2}, '}'];
    value = strsplit (w{4}, ' ');
    if sum (strcmp (name, names)) > 1    % which of its texts holds is not known
      continue
    end
    for k = find (cellfun (@(c) any (strcmp (c, name)), commands))
      parts = num2cell (commands{k});
      parts(strcmp (commands{k}, name)) = {value};
      commands{k} = [parts{:}];
    end
  end
end

% Types and their number, where a variable holds them: no case varies these.
function commands = withTypes (commands)
  isNumber = @(w) numel (w) == 4 && strcmp (w{1}, 'variable') && ...
                  any (strcmp (w{3}, {'equal', 'index'})) && ~isnan (str2double (w{4}));
  for words = commands(cellfun (isNumber, commands))
    [~, name, ~, value] = words{1}{:};
    for k = 1:numel (commands)
      w = commands{k};
      isAfter = [false, ismember(w(1:end - 1), {'type', 'atom_type', 'peratomtypepair', ...
                                                'peratomtype', 'create_atoms'})];
      commands{k}(isAfter & strcmp (w, ['${', name, '}'])) = {value};
    end
  end
end

% 1 x n cell of {property, what reads it}: of laws that the script does not choose (pages
% gran_model_* and rolling friction of the manual of LIGGGHTS 3.8).
function found = unreadProperties (commands)
  kinds = {'coefficientRollingViscousDamping', 'rolling_friction epsd3?(?!\w)', ...
           'rolling_friction epsd'; ...
           'kn|kt|gamman|gammat', 'model \S*stiffness', 'hooke/stiffness'; ...
           'youngsModulus|poissonsRatio|coefficientRestitution', ...
           'model (?!\S*stiffness)\S', 'hertz'; ...
           'characteristicVelocity', 'model (?!\S*stiffness)(?!hertz(?!\w))\S', 'hooke'; ...
           'surfaceTension', 'cohesion \S*capillary', 'cohesion easo/capillary/viscous'};
  found = cell (1, 0);
  isLaw = cellfun (@(w) any (strcmp (w, 'model')) && ...
                   (strcmp (w{1}, 'pair_style') || any (strcmp (w, 'wall/gran'))), commands);
  laws = cellfun (@(w) strjoin (w, ' '), commands(isLaw), 'UniformOutput', false);
  if isempty (laws) || any (~cellfun (@isempty, strfind (laws, '$')))
    return
  end
  for kind = kinds'
    isRead = any (~cellfun (@isempty, regexp (laws, kind{2}, 'once')));
    for words = commands
      w = words{1};
      isIt = numel (w) > 6 && strcmp (w{1}, 'fix') && ...
             ~isempty (regexp (w{5}, ['^(', kind{1}, ')$'], 'once')) && ...
             any (cellfun (@(v) str2double (v) ~= 0, w(6 + ~strcmp (w{6}, 'scalar'):end)));
      if isIt && ~isRead
        found{end + 1} = {w{5}, kind{3}};
      end
    end
  end
end

% 1 x n cell of {'1-2', command that does not read it}.
function pairs = inertPairs (commands, name, keyword)
  pairs = cell (1, 0);
  value = propertyOf (commands, name);
  models = contactModels (commands, keyword);
  if isempty (value) || isempty (models)
    return
  end
  n = rows (value);
  walls = unique ([models.types]);
  grains = grainTypes (commands, n, walls);
  for a = grains
    for b = a:n
      isWall = any (b == walls) && ~any (b == grains);
      mine = models(arrayfun (@(m) any (m.types == b), models));
      if ~isWall
        mine = models(strcmp ({models.what}, 'pair_style'));
      end
      isMeant = isWall || any (b == grains);
      if isMeant && ~strcmp (value{a, b}, '0') && ~isempty (mine) && ~any ([mine.reads])
        pairs{end + 1} = {sprintf('%d-%d', a, b), strjoin(unique ({mine.what}), ', ')};
      end
    end
  end
end

% n x n cell of texts, '0' where it is 0; {} where it is not set, or of no known form.
function value = propertyOf (commands, name)
  value = {};
  for words = commands
    w = words{1};
    if numel (w) < 7 || ~strcmp (w{1}, 'fix') || ~strcmp (w{5}, name) || ...
       ~strcmp (w{6}, 'peratomtypepair')
      continue
    end
    n = str2double (w{7});
    if n >= 1 && numel (w) >= 7 + n^2
      value = reshape (w(8:7 + n^2), n, n)';
      value(str2double (value) == 0) = {'0'};
    end
  end
end

% Of pair_style and each fix wall/gran: what (how the user finds it), reads (whether
% it has KEYWORD), types (of its wall; none where its script does not say).
function models = contactModels (commands, keyword)
  models = struct ('what', {}, 'reads', {}, 'types', {});
  meshes = struct ();
  for words = commands
    w = [words{1}, {''}];
    if strcmp (w{1}, 'pair_style') && any (strcmp (w, 'model'))
      models(end + 1) = struct ('what', 'pair_style', 'reads', readsIt (w, keyword), ...
                                'types', []);
    elseif strcmp (w{1}, 'fix') && numel (w) > 4 && strncmp (w{4}, 'mesh/surface', 12)
      meshes.(['x', regexprep(w{2}, '\W', '_')]) = typeAfter (w, 'type');
    elseif strcmp (w{1}, 'fix') && numel (w) > 4 && strcmp (w{4}, 'wall/gran')
      types = typeAfter (w, 'type');
      at = find (strcmp (w, 'meshes'), 1);
      for name = w(at + 1:end * ~isempty (at))
        types = [types, givenField(meshes, ['x', regexprep(name{1}, '\W', '_')], [])];
      end
      models(end + 1) = struct ('what', ['fix ', w{2}], ...
                                'reads', readsIt (w, keyword), ...
                                'types', unique (types));
    end
  end
end

% A variable may hold the keyword.
function yes = readsIt (w, keyword)
  law = w(1:find ([ismember(w, {'mesh', 'primitive'}), true], 1) - 1);
  at = find (strcmp (w, keyword), 1);
  yes = any (~cellfun (@isempty, strfind (law, '$'))) || ...
        (~isempty (at) && ~strcmp (w{at + 1}, 'off'));
end

function types = typeAfter (w, word)
  at = find (strcmp (w(1:end - 1), word));
  types = str2double (w(at + 1));
  types = types(isfinite (types));
end

% Types of templates, and of what create_atoms makes; where none is said, all that no
% wall has.
function grains = grainTypes (commands, n, walls)
  grains = [];
  for words = commands
    w = words{1};
    if numel (w) > 4 && strcmp (w{1}, 'fix') && strncmp (w{4}, 'particletemplate', 16)
      grains = [grains, typeAfter([w, {''}], 'atom_type')];
    elseif numel (w) > 1 && strcmp (w{1}, 'create_atoms')
      grains = [grains, str2double(w{2})];
    end
  end
  grains = unique (grains(isfinite (grains) & grains <= n));
  if isempty (grains)
    grains = setdiff (1:n, walls);
  end
end

%!shared base
%! base = ["fix m4 all property/global coefficientFriction peratomtypepair 2 0.4 0.5 0.5 0\n", ...
%!         "fix m5 all property/global coefficientRollingFriction peratomtypepair 2 ", ...
%!         "${r} ${w} ${w} 0.1\n", ...
%!         "pair_style gran model hertz tangential history rolling_friction epsd2\n", ...
%!         "fix t1 all particletemplate/sphere 1 atom_type 1 density constant 2400\n"];
%!test
%! wall = 'fix floor all wall/gran model hertz tangential history primitive type 2 zplane 0';
%! [notes, codes] = scriptPhysics ([base, wall, "\nthermo_modify lost error\n"]);
%! assert (codes, {'inert'});
%! assert (! isempty (strfind (notes{1}, 'rolling friction of types 1-2')), notes{1});
%! assert (! isempty (strfind (notes{1}, 'fix floor without rolling_friction')), notes{1});
%! both = strrep (wall, 'history', 'history rolling_friction epsd2');
%! assert (isempty (scriptPhysics ([base, both, "\n"])));
%! % a type that a variable holds
%! held = ["variable wt equal 2\n", base, strrep(wall, 'type 2', 'type ${wt}'), "\n"];
%! assert (numel (scriptPhysics (held)), 1);
%! assert (numel (scriptPhysics (strrep (held, 'equal', 'index'))), 1);
%! % another wall of that type reads it; a rolling friction of 0 is not missed
%! assert (isempty (scriptPhysics ([base, wall, "\n", strrep(both, 'floor', 'side'), "\n"])));
%! assert (isempty (scriptPhysics ([strrep(base, '${w}', '0.0'), wall, "\n"])));
%! % no wall has that type, and nothing is known of it
%! assert (isempty (scriptPhysics (base)));
%!test
%! % the grains themselves; walls of meshes; switched off
%! one = strrep (base, 'rolling_friction epsd2', 'rolling_friction off');
%! [notes, codes] = scriptPhysics (one);
%! assert (! isempty (strfind (notes{1}, 'types 1-1')), notes{1});
%! mesh = ["fix cad all mesh/surface file a.stl type 2 scale 1\n", ...
%!         "fix w all wall/gran model hertz tangential history mesh n_meshes 1 meshes cad\n"];
%! [~, codes] = scriptPhysics ([base, mesh]);
%! assert (codes, {'inert'});
%! glue = "fix c all property/global cohesionEnergyDensity peratomtypepair 1 ${c}\n";
%! [notes, codes] = scriptPhysics ([glue, "pair_style gran model hertz tangential history\n"]);
%! assert (codes, {'inert'});
%!test
%! % coefficients of laws that the script does not choose
%! law = @(name) ["pair_style gran model ", name, " tangential history rolling_friction epsd2\n"];
%! all_ = @(name, values) ["fix m all property/global ", name, " ", values, "\n"];
%! young = all_ ('youngsModulus', 'peratomtype 5e6');
%! [notes, codes] = scriptPhysics ([young, law('hooke/stiffness')]);
%! assert (codes, {'inert'});
%! assert (notes{1}, ['youngsModulus is set, but no contact model of the script reads it ', ...
%!                    '(hertz does)']);
%! assert (isempty (scriptPhysics ([young, law('hertz')])));
%! assert (isempty (scriptPhysics ([young, law('hooke')])));
%! for one = {'kn', 'peratomtypepair 1 1e5'; 'characteristicVelocity', 'scalar 2'; ...
%!            'coefficientRollingViscousDamping', 'peratomtypepair 1 0.3'; ...
%!            'surfaceTension', 'scalar 0.07'}'
%!   assert (scriptPhysics ([all_(one{:}), law('hertz')]){1}(1:numel (one{1})), one{1});
%! end
%! assert (isempty (scriptPhysics ([all_('kn', 'peratomtypepair 1 1e5'), ...
%!                                  law('hertz/stiffness')])));
%!test
%! % a law that a variable holds may have it
%! wall = "fix floor all wall/gran ${lawW} primitive type 2 zplane 0\n";
%! assert (isempty (scriptPhysics ([base, wall])));
%!test
%! [~, codes] = scriptPhysics ("thermo_modify norm no lost ignore\n");
%! assert (codes, {'lost'});
%! assert (isempty (scriptPhysics (["thermo_modify lost ignore\n", ...
%!                                  "variable n equal count(all)\n"])));
%! assert (isempty (scriptPhysics ("thermo_modify lost ignore\nthermo_modify lost error\n")));

% SPDX-License-Identifier: GPL-3.0-only
