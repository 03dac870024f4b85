% SAYMEASURE  Reads the angle of repose from a picture of a heap.
%
% CALL: STATUS = sayMeasure (ROOT, FOLDER, ARGS)
%
%   ROOT    folder of the toolbox (text, not used);  FOLDER  see commandMain
%   ARGS    cell of texts: path of the picture, --scale NUMBER (mm a pixel),
%           --model NAME, --name NAME (of the angle; default angle)
%   STATUS  0; 2 where the picture shows no two flanks
%
% Prints rows of measured.csv.
%
% Errors: DEcalioc:sayMeasure:badValue, those of commandOptions and
% pictureOutline

function status = sayMeasure (~, ~, args)
  [options, words] = commandOptions (args, struct ('scale', 'one', ...
                                                   'model', 'one', ...
                                                   'name', 'one'));
  if numel (words) ~= 1
    error ('DEcalioc:sayMeasure:badValue', ...
           ['measure needs one picture, got %d names. decalioc measure ' ...
            '--help shows the call.'], numel (words));
  end
  scale = NaN;
  if ~isempty (options.scale)
    scale = str2double (options.scale);
    if ~(scale > 0 && isfinite (scale)) || any (options.scale == ',')
      error ('DEcalioc:sayMeasure:badValue', ...
             '--scale must be millimetres a pixel, above 0, got %s.', ...
             options.scale);
    end
  end
  [x, z] = pictureOutline (words{1});
  heap = flankAngles (x, z);
  name = options.name;
  if isempty (name)
    name = 'angle';
  end
  printf ('# %s: flanks %.2f and %.2f deg, difference %.2f deg\n', words{1}, ...
          heap.left, heap.right, heap.difference);
  printf ('model,name,value,sd,unit\n');
  sayRow (options.model, name, heap.angle, heap.sd, 'deg');
  if ~isnan (scale)
    % an edge is seen to a pixel
    sayRow (options.model, 'radius', scale * heap.radius, ...
            scale * hypot (heap.radiusSd, 1), 'mm');
  end
  status = 2 * isnan (heap.angle);
end

function sayRow (model, name, value, sd, unit)
  printf ('%s\n', csvLine ({model, name, sprintf('%.4g', value), ...
                            sprintf('%.2g', sd), unit}));
end

%!test
%! picture = uint8 (255 * ones (300, 600));
%! [X, Y] = meshgrid ((1:600) - 300, 270 - (1:300));
%! picture(Y < 150 - max (X * tand (30), -X * tand (34)) & Y > 0) = 60;
%! file = [tempname(), '.png'];
%! imwrite (picture, file);
%! out = evalc ("status = sayMeasure ('', '', {file, '--scale', '0.12', '--model', 'Heap'});");
%! unlink (file);
%! assert (status, 0);
%! rowsOf = strsplit (out, "\n");
%! values = strsplit (rowsOf{3}, ',');
%! assert (values([1, 2, 5]), {'Heap', 'angle', 'deg'});
%! assert (str2double (values{3}), 32, 0.2);
%! assert (str2double (values{4}), 2, 0.2);
%! values = strsplit (rowsOf{4}, ',');
%! assert (str2double (values{3}), 0.12 * 75 * (cotd (30) + cotd (34)), 0.5);
%! % the rows are a table of measured values
%! table = tempname ();
%! writeAtomic (table, out);
%! [list, p] = readMeasured (table, {'Heap'});
%! assert (isempty (p));
%! assert ({list.name}, {'angle', 'radius'});
%!error <millimetres a pixel> sayMeasure ('', '', {'x.png', '--scale', '0,1'})
%!error id=DEcalioc:sayMeasure:badValue sayMeasure ('', '', {})

% SPDX-License-Identifier: GPL-3.0-only
